# A finished plan that the second opinion does not confirm
opinion-too-close = a second look at the finished plan finds '{ $first }' { FIXED($distance_m, digits: 4) } m from '{ $second }' (limit { FIXED($required_m, digits: 3) } m), { FIXED($time_s, digits: 3) } s after the beginning of { $part }. Plan again with another seed, or give the robot more room.
opinion-load-into-zone = a second look at the finished plan finds that a load that comes off at { FIXED($speed_m_s, digits: 3) } m/s, { FIXED($time_s, digits: 3) } s after the beginning of { $part }, would fly { FIXED($depth_m, digits: 4) } m into zone '{ $zone }'. Plan again with another seed, or give the robot more room.
opinion-too-fast = a second look at the finished plan finds a corner of '{ $body }' at { FIXED($speed_m_s, digits: 4) } m/s (limit { FIXED($limit_m_s, digits: 3) } m/s), { FIXED($time_s, digits: 3) } s after the beginning of { $part }. Plan again with another seed.
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
