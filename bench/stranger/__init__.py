"""Recordings of arms that exist nowhere else, with a cause planted in most: `python -m bench.stranger FOLDER`, which says the rest.

Written by somebody who had read the specification and not a line of core: arms, kinematics, motions, sensor and causes share no code with
what is tried on them.
"""
