"""Recordings of a second stranger's arms, with a cause planted in most: `python -m bench.stranger FOLDER --of second`.

Written by somebody else who had read the specification and not a line of core, nor of `bench.stranger`: it shares no code with either.
Whatever is drawn is drawn in the order in which it was first, and sums keep their order too, so the recordings are the same to the bit.
"""
