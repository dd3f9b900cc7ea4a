"""Recordings of a fifth stranger's machines, with a cause planted in most: `python -m bench.stranger FOLDER --of fifth`.

By somebody who had not read a line of core either, and who plants above all what the first four planted seldom: two causes at once, in
many combinations of families, and causes that no family describes. Machinery, measure and forms are those of `bench.fourth_stranger` and
`bench.second_stranger`; machines and causes are new.
"""
