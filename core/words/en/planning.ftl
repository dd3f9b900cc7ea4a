planning-rejected = { $reason } { $count }
planning-no-start-configuration =
    no start configuration with sensor axis { $axis } along gravity: rejected { $kinds ->
        [0] nothing, no candidate
       *[other] { $rejected }
    }. Move what is in the way, reduce the payload box, limits.clearance_m or limits.self_clearance_m, or search more (--effort), and plan again.
planning-no-start-configuration-near =
    no start configuration with sensor axis { $axis } along gravity: rejected { $kinds ->
        [0] nothing, no candidate
       *[other] { $rejected }
    }; the best clearance met was { FIXED($best_clearance_m, digits: 3) } m to { $nearest }. Move what is in the way, reduce the payload box, limits.clearance_m or limits.self_clearance_m, or search more (--effort), and plan again.
planning-other-axes = { $refusal } There is a plan for the other sensor axes: --axes { $axes }.

# What rejects a candidate for a start configuration.
planning-rejected-unreachable = unreachable
planning-rejected-obstacle = too close to { $body }
planning-rejected-bodies = { $first } too close to { $second }
planning-rejected-throw = a released load would fly into zone "{ $zone }"
planning-rejected-joint-too-weak = joint "{ $joint }" too weak to hold the load
planning-rejected-rotation-bodies = no room for the rotation: { $first } too close to { $second }
planning-rejected-joint-limits = joint limits during the rotation
planning-rejected-joint-speed = joint velocity during the rotation
planning-rejected-joint-acceleration = joint acceleration during the rotation
planning-rejected-cartesian-speed = Cartesian speed during the rotation

# The ends of a path.
planning-end-start = start
planning-end-goal = goal
planning-end-no-configuration = the { $end } of the path is { $q_rad }; expected { $count } finite joint positions in rad.
planning-end-outside-limits = the { $end } of the path has { $joint } at { FIXED($angle_rad, digits: 3) } rad, outside its limits [{ FIXED($lower_rad, digits: 3) }, { FIXED($upper_rad, digits: 3) }] rad. Choose another { $end } configuration.
planning-end-inside = at the { $end } of the path { $first } reaches { FIXED($depth_m) } m into { $second }. Choose another { $end } configuration, reduce the payload box, or clear the cell.
planning-end-too-close = at the { $end } of the path { $first } is { FIXED($distance_m, digits: 4) } m from { $second } (limit { FIXED($required_m, digits: 3) } m). Choose another { $end } configuration or clear the cell.
planning-end-drops-load = at the { $end } of the path a load that comes off would fall { FIXED($depth_m, digits: 4) } m into zone "{ $zone }". Choose another { $end } configuration, reduce the payload box, or move the zone.

# No path, or none that may be commanded.
planning-no-path = no path found in { $iterations } iterations by { $planner }: the search from the start came within { FIXED($left_rad, digits: 2) } rad of the goal, { FIXED($whole_rad, digits: 2) } rad away; the tighter end has { $first } { FIXED($distance_m, digits: 3) } m from { $second } (limit { FIXED($required_m, digits: 3) } m). Search more (--effort), choose another start configuration, or clear the cell.
planning-corner-too-tight = a corner of the path at ({ $corner_rad }) rad cannot be rounded by { FIXED($smallest_rad, digits: 4) } rad without coming closer than the clearance. Plan again with another seed, or give the path more room.
planning-rounding-too-close = the timed path comes { FIXED($depth_m, digits: 4) } m too close ({ $first } to { $second }) where its corners are rounded. Plan again with another seed, or give the path more room.
planning-no-timing = no timing of the path keeps the limits: { FIXED($excess, digits: 3) } times a limit after { $rounds } rounds. Plan again.
planning-transfer-throws-load = a load that comes off { FIXED($time_s, digits: 3) } s after the beginning of the path, at { FIXED($speed_m_s, digits: 3) } m/s, would fly { FIXED($depth_m, digits: 4) } m into zone "{ $zone }". Plan again with another seed, reduce the payload box, or move the zone.
planning-stands-inside = where the robot stands, { $first } reaches { FIXED($depth_m) } m into { $second }. Reduce the payload box, or clear the cell.
planning-stands-too-close = the robot stands with { $first } { FIXED($distance_m, digits: 4) } m from { $second } (limit { FIXED($required_m, digits: 3) } m). Clear the cell.
planning-no-room-for-wave = no room for a wide-band motion: even joint swings of { MILLI($swing_rad, digits: 1) } mrad leave the limits, come too close to something, or could throw a load into a zone. Choose another motion, or give the robot more room.

# Joint torques with the load.
planning-load-known = payload "{ $payload }" as the cell knows it
planning-load-guessed = a guessed mass, spread evenly over the payload box
planning-load-payload-limit = the robot's payload limit, spread evenly over the payload box
planning-joint-without-effort = "{ $joint }": the URDF states no effort
planning-joint-without-mass = "{ $joint }": the URDF states no mass of the link after "{ $after }"
planning-too-heavy = the load of { FIXED($mass_kg, digits: 3) } kg is too heavy for "{ $joint }": it would need { FIXED($torque_n_m, digits: 1) } N m (limit { FIXED($limit_n_m, digits: 1) } N m), { FIXED($holding_n_m, digits: 1) } N m of them to hold still, { FIXED($time_s, digits: 3) } s after the beginning of { $part }. Take a lighter payload or another home, or correct the effort in the URDF.
planning-too-heavy-to-hold = no start configuration with sensor axis { $axis } along gravity: the load is too heavy, to hold it still "{ $joint }" would need { PERCENT($share) } % of its torque at least (limit { PERCENT($most_share) } %). Take a lighter payload, give the robot more room, or correct the effort in the URDF.

# Parts of a plan, and what a second look at it finds.
planning-part-transfer = transfer { $axis }
planning-part-rotation = rotation { $axis }
planning-part-wave = wave { $axis }
planning-part-home = home
planning-part-start = start
planning-not-feasible = the finished plan cannot be carried out in { $part }. Plan again with another seed.
planning-disputed-distance = a second look at the finished plan finds { $first } { FIXED($distance_m, digits: 4) } m from { $second } (limit { FIXED($required_m, digits: 3) } m), { FIXED($time_s, digits: 3) } s after the beginning of { $part }. Plan again with another seed, or give the robot more room.
planning-disputed-throw = a second look at the finished plan finds that a load that comes off at { FIXED($speed_m_s, digits: 3) } m/s, { FIXED($time_s, digits: 3) } s after the beginning of { $part }, would fly { FIXED($depth_m, digits: 4) } m into zone "{ $zone }". Plan again with another seed, or give the robot more room.
planning-disputed-speed = a second look at the finished plan finds a corner of { $body } at { FIXED($speed_m_s, digits: 4) } m/s (limit { FIXED($limit_m_s, digits: 3) } m/s), { FIXED($time_s, digits: 3) } s after the beginning of { $part }. Plan again with another seed.

# Flaws of what a plan was asked for with.
planning-axes-unknown =
    .found = "{ $axes }"
    .expected = some of x, y and z with commas between them
planning-torques-whole =
    .found = joint-torques beside { $option }
    .expected = one of the two: motions for the torques of the joints turn about no sensor axis, and are made whole
planning-speed-out-of-range =
    .found = { SIGNIFICANT($speed_m_s, digits: 6) } m/s
    .expected = { SIGNIFICANT($slowest_m_s, digits: 6) } to { SIGNIFICANT($limit_m_s, digits: 6) } m/s, the limit of the cell
planning-start-wanted = joint positions like "0.1,-1.2,...", the folder of a recording, or a JSON file with "q_rad"
planning-start-empty =
    .found = nothing
    .expected = { planning-start-wanted }
planning-start-unreadable =
    .found = "{ $text }"
    .expected = { planning-start-wanted }
planning-start-no-json =
    .found = no JSON
    .expected = { planning-start-wanted }
planning-start-joints =
    .found = { $q_rad }
    .expected = { $count } finite joint positions in rad, for { $joints }
planning-start-recording-without-joints =
    .found = a recording without joint positions
    .expected = one with q or q_cmd
planning-start-file-too-long =
    .found = a file that is too long
    .expected = at most { $most_bytes } bytes
planning-period-no-multiple =
    .found = { SIGNIFICANT($period_s, digits: 6) } s
    .expected = a multiple of { SIGNIFICANT($own_s, digits: 6) } s, the period of the plan, up to { SIGNIFICANT($most_s, digits: 6) } s
planning-period-without-file =
    .found = { SIGNIFICANT($period_s, digits: 6) } s without --trajectory
    .expected = --trajectory FILE, which it is for
planning-trajectory-file-ending =
    .found = { $file }
    .expected = a file that ends with .csv or .json
planning-trajectory-folder-missing =
    .found = { $file }, in a folder that does not exist
    .expected = a file in an existing folder
