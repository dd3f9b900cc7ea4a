# What in a cell.toml cannot be read.
cell-no-toml =
    .found = TOML that does not parse ({ $reason })
    .expected = TOML
cell-unknown-key =
    .found = an unknown key
    .expected = '{ $close }', if that is what was meant
cell-shape-without-kind =
    .found = no such key
    .expected = box, sphere, capsule or cylinder
cell-unknown-shape =
    .found = '{ $kind }'
    .expected = box, sphere, capsule or cylinder
cell-unknown-driver =
    .found = '{ $driver }'
    .expected = one of { $drivers }

# Which cell is meant.
cell-argument = cell
cell-nearly-named =
    .found = '{ $name }'
    .expected = '{ $close }', if that is what was meant
cell-unknown =
    .found = '{ $name }'
    .expected = one of { $known }, or a folder with { $file }

# What does not go with another value of the cell.
cell-name-twice =
    .found = the name '{ $name }' { $count } times
    .expected = each name once
cell-gravity-strength =
    .found = ({ $gravity_m_s2 }) m/s2, { FIXED($strength_m_s2, digits: 3) } m/s2 strong
    .expected = that of the earth, { FIXED($least_m_s2, digits: 1) } to { FIXED($most_m_s2, digits: 1) } m/s2
cell-gravity-tilted =
    .found = ({ $gravity_m_s2 }) m/s2, { DEGREES($angle_rad, digits: 0) } degrees from straight down
    .expected = at most { DEGREES($most_rad, digits: 0) } degrees: z of the world points up, a robot on a wall or a ceiling is turned by robot.base
cell-floor-above-base =
    .found = { SIGNIFICANT($floor_z_m, digits: 6) } m, above the robot's base at { SIGNIFICANT($base_z_m, digits: 6) } m
    .expected = a floor below the base
cell-floor-too-deep =
    .found = { SIGNIFICANT($floor_z_m, digits: 6) } m, { FIXED($depth_m, digits: 1) } m below the robot's base
    .expected = a floor at most { FIXED($most_m, digits: 0) } m below the base
cell-box-too-large =
    .found = a corner { FIXED($distance_m, digits: 2) } m from the sensor
    .expected = none farther than { FIXED($most_m, digits: 0) } m
cell-base-inside =
    .found = the robot's base { FIXED($depth_m, digits: 3) } m inside it
    .expected = the base outside (at most { FIXED($most_m, digits: 3) } m inside)
cell-sensor-coarse =
    .found = { SIGNIFICANT($figure, digits: 6) }
    .expected = less than a tenth of sensor.range, { SIGNIFICANT($range, digits: 6) }
cell-sensor-force-too-weak =
    .found = { SIGNIFICANT($range_n, digits: 6) } N for { $axis }
    .expected = more than the weight of { $carried } puts on it, { SIGNIFICANT($load_n, digits: 3) } N
cell-sensor-torque-too-weak =
    .found = { SIGNIFICANT($range_n_m, digits: 6) } N m for { $axis }
    .expected = more than the weight of { $carried } puts on it, { SIGNIFICANT($load_n_m, digits: 3) } N m

# Payloads.
cell-payload-inertia =
    .found = mass { SIGNIFICANT($mass_kg, digits: 6) }, first_moment ({ $first_moment_kg_m }), inertia ({ $inertia_kg_m2 })
    .expected = values that a rigid body can have (pseudo-inertia positive definite)
cell-payload-too-heavy =
    .found = { SIGNIFICANT($mass_kg, digits: 6) } kg
    .expected = at most the robot's payload_limit_kg, { SIGNIFICANT($most_kg, digits: 6) } kg
cell-payload-outside-box =
    .found = a centre of mass at ({ $com_m }) m, { FIXED($distance_m, digits: 3) } m outside the box
    .expected = a box that contains the payload

# What does not go with the URDF.
cell-no-such-link =
    .found = '{ $link }'
    .expected = a link of { $urdf }: { $links }
cell-no-visual-shape =
    .found = '{ $link }'
    .expected =
        a link of { $urdf } with a <visual> and without a <collision>, { $count ->
            [0] of which there is none
           *[other] one of { $links }
        }
cell-not-one-for-each-joint =
    .found =
        { $count ->
            [one] { $count } value
           *[other] { $count } values
        }
    .expected = { $joint_count }, for { $joints }
cell-home-outside-limits =
    .found = { SIGNIFICANT($home_rad, digits: 6) } for '{ $joint }'
    .expected = a position between { SIGNIFICANT($lower_rad, digits: 6) } and { SIGNIFICANT($upper_rad, digits: 6) } rad
cell-velocity-too-high =
    .found = { SIGNIFICANT($velocity_rad_s, digits: 6) } for '{ $joint }'
    .expected = at most the URDF's { SIGNIFICANT($most_rad_s, digits: 6) } rad/s
