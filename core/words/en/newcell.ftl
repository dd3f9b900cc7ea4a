# What is looked for in a cell: wrong is what keeps it from being planned in, doubtful what somebody should look at.
newcell-wrong = wrong: { $flaw }.
newcell-doubtful = doubtful: { $doubt }.
newcell-no-model =
    .found = a model that cannot be built ({ $reason })
    .expected = links and meshes of which one can be
newcell-gravity-tilted =
    .found = ({ $gravity_m_s2 }) m/s2, { DEGREES($angle_rad, digits: 0) } degrees from straight down
    .expected = straight down: a tilted robot is turned by robot.base.rpy_rad, not by gravity
newcell-speed-high =
    .found = { SIGNIFICANT($speed_m_s, digits: 6) } m/s
    .expected = at most { SIGNIFICANT($most_m_s, digits: 6) } m/s, where people are near
newcell-acceleration-unusual =
    .found = { SIGNIFICANT($acceleration_rad_s2, digits: 6) } rad/s2
    .expected = what the robot's maker states; { SIGNIFICANT($least_rad_s2, digits: 6) } to { SIGNIFICANT($most_rad_s2, digits: 6) } rad/s2 is usual
newcell-friction-unknown =
    .found = nothing
    .expected = what is known of the drives; without it a diagnosis judges friction by the tracking error alone
newcell-zones-none =
    .found = none
    .expected = a [[zones]] for every place where people may be; without one nothing is kept away from them
newcell-payloads-none =
    .found = none
    .expected = a [payloads.NAME] to simulate a run or to compare the answer with; planning needs none
newcell-pair-unwatched =
    .found = '{ $first }' and '{ $second }' left out
    .expected = two links that cannot touch: look at them on the robot, nothing watches how far they are from each other
newcell-link-as-it-looks =
    .found = '{ $link }' as it looks
    .expected = a shape for collisions in the URDF, with cables and covers, if the visual one lacks them
newcell-sensor-not-stated =
    .found = '{ $name }'
    .expected = noise, range and resolution of the sensor that is there: intervals count with them
newcell-mount-unknown =
    .found = nothing
    .expected = the sensor frame in the flange, without which a payload is exported in the sensor frame alone
newcell-sensor-small =
    .found = { SIGNIFICANT($range_n, digits: 6) } N for the { FIXED($weight_n, digits: 0) } N of '{ $payload }'
    .expected = a sensor with room for what a motion adds
newcell-sensor-large =
    .found = { SIGNIFICANT($range_n, digits: 6) } N for the { SIGNIFICANT($weight_n, digits: 2) } N of '{ $payload }'
    .expected = a finer sensor: its errors go with its range
newcell-effort-none =
    .found = an effort of { SIGNIFICANT($effort_n_m, digits: 6) } N m
    .expected = the joint's greatest torque: without it none is checked
newcell-effort-low =
    .found = an effort of { SIGNIFICANT($effort_n_m, digits: 6) } N m, where the arm and its tools may ask { FIXED($needed_n_m, digits: 0) } N m when it is stretched out
    .expected = the joint's greatest torque and the links' masses as the maker states them
newcell-floor-above-base =
    .found = { SIGNIFICANT($floor_z_m, digits: 6) } m, above the lowest point of the robot's base at { FIXED($base_z_m, digits: 3) } m
    .expected = the height of the floor
newcell-floor-far-below =
    .found = { FIXED($depth_m, digits: 1) } m below the robot's base
    .expected = the height of the floor, in the world frame
newcell-zone-within-reach =
    .found = at most { FIXED($distance_m, digits: 2) } m from the shoulder of an arm that reaches { FIXED($reach_m, digits: 2) } m
    .expected = a guard that does not depend on planning, wherever people may be in it
newcell-box-off-flange =
    .found = a box { FIXED($distance_m, digits: 3) } m away from the flange face
    .expected = a box that begins at the sensor frame's origin: what holds the payload takes room, too
newcell-box-long =
    .found = { SIGNIFICANT($length_m, digits: 6) } m long, for an arm of { FIXED($reach_m, digits: 2) } m
    .expected = the size of what hangs there: little may be left to move in
newcell-home-narrow =
    .found = '{ $first }' { FIXED($distance_m, digits: 3) } m from '{ $second }', of which { FIXED($required_m, digits: 3) } m are required
    .expected = a home with more room: every run begins and ends there
newcell-shapes-overlap =
    .found = '{ $first }' and '{ $second }', whose shapes overlap at every angle of the joints between them, left out
    .expected = two links that cannot meet on the robot: look at them, and mend their shapes if they can

# What was ordered.
newcell-no-name =
    .found = '{ $name }'
    .expected = 1 to 64 letters, digits, - and _; --into DIR says where the cell's folder is made
newcell-two-sensor-frames =
    .found = both --sensor-frame and --mount
    .expected = one of them
newcell-exists =
    .found = something that exists already
    .expected = a new name
newcell-no-folder =
    .found = something that is no folder
    .expected = a folder
newcell-no-package-path =
    .found = no such folder
    .expected = a folder with ROS packages, or a package
newcell-not-written =
    .found = a folder that cannot be written ({ $reason })
    .expected = a disk with room, and permission
newcell-joint-unknown =
    .found = a joint that is not the arm's
    .expected = one of { $joints }
newcell-link-unmoved =
    .found = a link that no joint of the arm moves
    .expected = one of { $links }
newcell-range-empty =
    .found = { SIGNIFICANT($lower_rad, digits: 4) } rad
    .expected = less than the upper limit, { SIGNIFICANT($upper_rad, digits: 4) } rad
newcell-no-such-link =
    .found = no such link in { $file }
    .expected = one of { $links }

# Packages and meshes that the description names.
newcell-package = { $file }: package '{ $name }'
newcell-no-package-name =
    .found = no name of a package
    .expected = letters, digits, _, - and .
newcell-no-such-package =
    .found = no such package in { $folders } or above
    .expected = a folder of that name; --package-path DIR says where it is
newcell-mesh-address =
    .found = '{ $name }'
    .expected = package://, or a path relative to the description
newcell-mesh-outside =
    .found = '{ $name }', which leads outside the description's folder
    .expected = --package-path DIR for a folder that may be read
newcell-no-mesh =
    .found = '{ $name }'
    .expected = a mesh, one of { $suffixes }
newcell-no-shapes =
    .found = no shape on any link that moves
    .expected = links with collision or visual shapes

# Links and joints of the description.
newcell-link-name =
    .found = '{ $name }'
    .expected = a name of at most { $most } characters that can be printed
newcell-link-exists =
    .found = '{ $link }' already in the description
    .expected = --sensor-frame { $link } in place of --mount
newcell-no-turning-joint =
    .found = no joint that turns
    .expected = an arm of revolute joints
newcell-sensor-on-no-arm =
    .found = no moving joint above it
    .expected = a sensor frame at the end of an arm
newcell-base-frame = { $file }: base frame '{ $base }'
newcell-base-apart =
    .found = no chain of joints from it to '{ $sensor }'
    .expected = a link above the sensor frame
newcell-base-unmoved =
    .found = no moving joint between it and '{ $sensor }'
    .expected = an arm between the two
newcell-joint-of-no-arm =
    .found =
        a joint between '{ $base }' and '{ $sensor }' that { $mimics ->
            [true] mimics another
           *[false] is { $type }
        }
    .expected = joints that turn; --base-frame { $child } takes the arm behind it, --sensor-frame { $parent } the one before
newcell-behind-sensor = { $file }: links behind the sensor frame '{ $sensor }'
newcell-links-of-none =
    .found = { $links }
    .expected = --behind-sensor tool where the sensor carries them, --behind-sensor robot where it sits behind them
newcell-what-is-behind = Behind the sensor frame '{ $sensor }' hang { $links }. Does the sensor carry them (tool), or sit behind them (robot)?
newcell-home = { $file }: home
newcell-no-home =
    .found = none of { $count } configurations free, mostly for '{ $first }' and '{ $second }'
    .expected = shapes that leave the arm room, or links behind the sensor frame declared with --behind-sensor

# What was chosen, taken or left out: frames.
newcell-sensor-mounted = The sensor frame is the new link '{ $link }', fixed to '{ $mount }'.
newcell-sensor-named = The sensor frame is '{ $link }', which has the name of a force/torque sensor; --sensor-frame LINK chooses another.
newcell-sensor-last = The sensor frame is '{ $link }', the last link of the longest chain before a hand; --sensor-frame LINK chooses another.
newcell-sensor-moved = The sensor frame is moved from '{ $before }' behind what counts as robot, to '{ $sensor }': { $links }.
newcell-felt-as-tool = Behind the sensor frame '{ $sensor }', felt by the sensor as a tool: { $links }.
newcell-beside-sensor = Carried by the last joint but not by the sensor, and so part of the robot: { $links }.
newcell-base-chosen = The base frame is '{ $link }', which carries the first moving joint; --base-frame LINK chooses another.

# ... joints and links.
newcell-joint-fixed =
    Joint '{ $joint }' ({ $type }{ $mimics ->
        [true] {" "}that mimics another
       *[false] {""}
    }) is not the arm's: fixed at { SIGNIFICANT($angle_rad, digits: 6) } rad.
newcell-slide-fixed =
    Joint '{ $joint }' ({ $type }{ $mimics ->
        [true] {" "}that mimics another
       *[false] {""}
    }) is not the arm's: fixed at { SIGNIFICANT($place_m, digits: 6) } m.
newcell-endless-limited = Joint '{ $joint }' turns without end: limited to { SIGNIFICANT($lower_rad, digits: 4) } ... { SIGNIFICANT($upper_rad, digits: 4) } rad.
newcell-range-taken = Joint '{ $joint }' has no limits of position: { SIGNIFICANT($lower_rad, digits: 4) } ... { SIGNIFICANT($upper_rad, digits: 4) } rad taken; put in the robot's own.
newcell-velocity-taken = Joint '{ $joint }' has no limit of velocity: { SIGNIFICANT($velocity_rad_s, digits: 6) } rad/s taken; put in the robot's own.
newcell-effort-taken = Joint '{ $joint }' has no limit of torque: { SIGNIFICANT($effort_n_m, digits: 6) } N m taken, { SIGNIFICANT($times, digits: 6) } times what the arm's own weight can ask; put in the robot's own.
newcell-accelerations-taken = Accelerations of { $accelerations_rad_s2 } rad/s2 taken: each joint's greatest speed in { SIGNIFICANT($seconds_s, digits: 2) } s, between { SIGNIFICANT($least_rad_s2, digits: 3) } and { SIGNIFICANT($most_rad_s2, digits: 3) } rad/s2.
newcell-mass-taken = Link '{ $link }' has no mass: { SIGNIFICANT($mass_kg, digits: 3) } kg from its shape at { FIXED($density_kg_m3, digits: 0) } kg/m3 taken; put in the robot's own, torques and the simulation count with it.
newcell-inertia-taken = Link '{ $link }' has no inertia that a body can have: that of its shape with its { SIGNIFICANT($mass_kg, digits: 3) } kg taken; put in the robot's own, torques and the simulation count with it.
newcell-visual-taken = Link '{ $link }' has no shape for collisions: its visual shape is taken (robot.visual_shapes).
newcell-pair-left-out = '{ $first }' and '{ $second }' overlap wherever they were looked at: left out (robot.adjacent).
newcell-pair-overlaps = They overlap, or nearly so, in all { $count } positions of the arm that were looked at.
newcell-pair-declared = You have left them out; nothing shows that they always overlap.

# ... room, home and sensor.
newcell-floor-out-of-reach = The arm hangs below its base: the floor is put out of reach, at { SIGNIFICANT($floor_z_m, digits: 6) } m; put in its height.
newcell-box-without-home = With a payload box { SIGNIFICANT($width_m, digits: 6) } m wide, { SIGNIFICANT($gap_m, digits: 6) } m from the flange face, no home is free, mostly for '{ $first }' and '{ $second }'.
newcell-payload-box = The payload box is { SIGNIFICANT($x_m, digits: 6) } x { SIGNIFICANT($y_m, digits: 6) } x { SIGNIFICANT($z_m, digits: 6) } m, { SIGNIFICANT($gap_m, digits: 6) } m from the flange face; put what really hangs there into cell.toml.
newcell-nearest-at-home = At home '{ $first }' and '{ $second }' are nearest, { FIXED($distance_m, digits: 3) } m apart.
newcell-sensor-of-nobody = The sensor's noise, range and resolution are nobody's figures: put in yours.

# The picture.
newcell-picture = { $name } at home
newcell-picture-colours = arm blue, base grey, tool green, room of the payload orange; sensor axes x red, y green, z blue
