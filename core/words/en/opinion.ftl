# What two solids are to each other
opinion-kind-environment = obstacles, zones and floor
opinion-kind-first-link = first link against obstacles, zones and floor
opinion-kind-mount = first links against what the robot is mounted on
opinion-kind-payload = payload against links
opinion-kind-links = links against links
opinion-kind-near = near each other by construction
opinion-kind-joined = left out
# Why something is asked of them, or nothing
opinion-pair-clearance = the cell's clearance
opinion-pair-self-clearance = the cell's self-clearance
opinion-pair-mounted-there = never as far apart as the clearance: the robot is mounted there
opinion-pair-cannot-touch = they cannot touch, as a grid of the angles between them says
opinion-pair-always-near = never as far apart as the self-clearance
opinion-pair-no-joint-between = no joint between them: they do not move against each other
opinion-pair-declared = declared in the cell: robot.adjacent
opinion-pair-neighbours = neighbours: one joint joins them
opinion-pair-overlapping = their shapes overlap at every angle: by construction
opinion-pair = { $first } - { $second }
opinion-left-out = { $pairs }: { $reason }
