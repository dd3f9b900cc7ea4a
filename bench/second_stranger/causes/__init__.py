"""What is planted: in each file the causes of one place, each a function that draws it for a rig.

They are called what the stranger called them, since the truth about a recording quotes that: `drift_hvac`, say.
"""
