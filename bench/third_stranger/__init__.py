"""Recordings of a third stranger's arms, with a cause planted in most: `python -m bench.stranger FOLDER --of third`.

By somebody who had not read a line of core either, and who varies what the first two held constant: how fast and in which form a
recording is written, where the arm stands, how the sensor was tared, and what the arm does. The rigid bodies, the kinematics and the
measure of what is to be seen are those of `bench.second_stranger`; arms, motions, forms, noise and causes are new.
"""
