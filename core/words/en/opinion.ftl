# Why the second opinion asks of two bodies what it asks, or nothing.
opinion-clearance = the cell's clearance
opinion-self-clearance = the cell's self-clearance
opinion-mounted-there = never as far apart as the clearance: the robot is mounted there
opinion-cannot-touch = they cannot touch, as a grid of the angles between them says
opinion-always-near = never as far apart as the self-clearance
opinion-shapes-overlap = their shapes overlap at every angle: by construction
opinion-no-joint-between = no joint between them: they do not move against each other
opinion-declared-adjacent = declared in the cell: robot.adjacent
opinion-neighbours = neighbours: one joint joins them
