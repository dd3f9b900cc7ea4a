# The model
robot-joints-not-of-chain =
    .found = { $joints }
    .expected = the chain's joints in its order, { $chain }
robot-urdf-not-taken =
    .found = a URDF that Pinocchio does not take ({ $reason })
    .expected = a robot
robot-sensor-frame-elsewhere =
    .found = '{ $frame }'
    .expected = a frame behind the last joint
# Where it stands
robot-nothing-of-that-name =
    .found = no obstacle and no zone '{ $name }'
    .expected = one of { $names }
robot-base-inside =
    .found = '{ $link }' of the robot { FIXED($depth_m, digits: 3) } m inside it
    .expected = the robot's base outside (at most { SIGNIFICANT($most_m, digits: 3) } m sunk into what it is mounted on)
robot-home-too-close =
    .found = '{ $first }' { FIXED($distance_m, digits: 3) } m from '{ $second }'
    .expected = at least { FIXED($required_m, digits: 3) } m at home ({ $keys })
robot-box-inside-at-home = The tool's box reaches { FIXED($depth_m) } m into { $second } at home. Make the box smaller, choose another tool, or move the home position or what stands there.
robot-box-near-at-home = The tool's box is { FIXED($distance_m, digits: 3) } m from { $second } at home (limit { FIXED($required_m, digits: 3) } m). Make the box smaller, choose another tool, or move the home position or what stands there.
robot-keys-of-clearance = limits.clearance_m
robot-keys-of-carried = limits.self_clearance_m, or a smaller box of payload or tool
robot-keys-of-links = limits.self_clearance_m, or the pair in robot.adjacent
# Why nobody watches the distance of two bodies
robot-pair-no-joint-between = no joint between them: they do not move against each other
robot-pair-declared = declared in the cell: robot.adjacent
robot-pair-neighbours = neighbours: one joint joins them
robot-pair-cannot-touch = they cannot touch, whatever the joints between them do
robot-pair-overlapping = their shapes overlap whatever the joints between them do: by construction
robot-pair-first-joint-only = only the first joint moves it, and it keeps the clearance at every angle
robot-pair-mounted-there = always nearer than the clearance, and they cannot touch: the robot is mounted there
