# What is proposed to be measured next.
experiment-swings = rotation about the sensor's { $axis } axis, held horizontal with { $down } pointing down: gravity sweeps through the sensor
experiment-tilted-holds = holds with gravity along four diagonals of the sensor frame
experiment-revisit = the first hold once more
experiment-both-sides = the first hold, approached from one side and from the other
experiment-wide-band = a wide-band motion about all axes at once, { SIGNIFICANT($lowest_hz) } to { SIGNIFICANT($highest_hz) } Hz
experiment-other-posture = the first hold in another posture of the arm
experiment-second-payload = the same run with a second payload whose mass and centre of mass are known: no motion with this one gets the explanations further apart than { FIXED($best_sigma, digits: 1) } standard deviations

# Flaws.
experiment-name = the experiment
experiment-without-stops =
    .found = no stops
    .expected = a motion; a second payload is put on by hand and run with `heft run`
