"""What is planted: in each file the causes of one place, each a function that draws it for a rig, called as the truth quotes it."""
