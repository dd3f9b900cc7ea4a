"""Recordings of a fourth stranger's machines, with a cause planted in most: `python -m bench.stranger FOLDER --of fourth`.

By somebody who had not read a line of core either, and who varies what the first three held constant: what kind of machine it is and how
it is mounted, how large its payload is and how far out, and what a log is like that was not made for the purpose. The rigid bodies, the
kinematics and the measure of what is to be seen are those of `bench.second_stranger`; machines, motions, forms and causes are new.
"""
