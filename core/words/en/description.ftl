# The file as a whole.
description-too-long =
    .found = { $characters } characters
    .expected = at most { $most }
description-declaration =
    .found = the declaration { $declaration }
    .expected = a URDF without document types and entities
description-no-xml =
    .found = XML that does not parse ({ $reason })
    .expected = a URDF
description-of-no-robot =
    .found = the element <{ $tag }>
    .expected = <robot>
description-robot-without-name =
    .found = <robot> without a name
    .expected = a name
description-too-deep =
    .found = elements nested more than { $most } deep
    .expected = a URDF
description-incomplete =
    .found = the element <{ $tag }>
    .expected = a URDF that is complete in itself (xacro expanded, nothing included)

# Numbers.
description-no-value =
    .found = no value
    .expected =
        { $count ->
            [1] a finite number
           *[other] { $count } finite numbers
        }
description-no-number =
    .found = '{ $text }'
    .expected =
        { $count ->
            [1] a finite number
           *[other] { $count } finite numbers
        }
description-too-far =
    .found = '{ $text }'
    .expected = a value that a robot cell can have, in SI units

# Shapes.
description-no-shape =
    .found = no shape
    .expected = one of { $kinds }
description-unknown-shape =
    .found = { $shapes }
    .expected = one of { $kinds }
description-size-not-positive =
    .found = '{ $sizes }'
    .expected = positive sizes
description-mesh-without-file =
    .found = no filename
    .expected = a file
description-mesh-elsewhere =
    .found = '{ $name }'
    .expected = a path relative to the URDF, inside its folder
description-link-only-looks =
    .found = a link that moves without a shape for collisions
    .expected = <collision>, or '{ $link }' in robot.visual_shapes of cell.toml, where its looks are to count
description-link-without-shape =
    .found = a link that moves without a shape for collisions
    .expected = <collision>, or neither mass nor shape where it is only a frame

# Masses.
description-without-mass =
    .found = no mass
    .expected = mass and inertia
description-without-inertia =
    .found = no inertia
    .expected = mass and inertia
description-negative-mass =
    .found = { SIGNIFICANT($mass_kg, digits: 6) } kg
    .expected = a mass that is not negative
description-negative-moment =
    .found = a negative moment among ixx, iyy, izz = { SIGNIFICANT($ixx_kg_m2, digits: 6) }, { SIGNIFICANT($iyy_kg_m2, digits: 6) }, { SIGNIFICANT($izz_kg_m2, digits: 6) }
    .expected = none
description-without-inertial =
    .found = no inertial
    .expected = mass and inertia of a link that moves
description-massless =
    .found = { SIGNIFICANT($mass_kg, digits: 6) } kg
    .expected = a positive mass of a link that moves
description-inertia-not-definite =
    .found = a principal moment of { SIGNIFICANT($moment_kg_m2, digits: 3) } kg m2
    .expected = a positive definite inertia
description-inertia-of-none =
    .found = principal moments { SIGNIFICANT($least_kg_m2, digits: 4) }, { SIGNIFICANT($middle_kg_m2, digits: 4) }, { SIGNIFICANT($most_kg_m2, digits: 4) } kg m2
    .expected = none larger than the sum of the other two

# Joints.
description-unknown-joint-type =
    .found = '{ $type }'
    .expected = one of { $types }
description-joint-without-link =
    .found = no link
    .expected = the name of a link
description-unknown-link =
    .found = '{ $link }'
    .expected = a link of the URDF
description-joint-without-limits =
    .found = a joint without limits (continuous)
    .expected = a revolute joint with lower, upper and velocity limits
description-joint-mimics =
    .found = a joint that mimics another
    .expected = a revolute joint of its own
description-joint-not-revolute =
    .found = the type '{ $type }'
    .expected = a revolute joint of its own
description-axis =
    .found = ({ $axis })
    .expected = a direction
description-limit-missing =
    .found = no { $key }
    .expected = the limits { $keys }
description-limits =
    .found = lower { SIGNIFICANT($lower_rad, digits: 6) }, upper { SIGNIFICANT($upper_rad, digits: 6) }
    .expected = lower < upper within +-{ FIXED($most_rad, digits: 2) } rad
description-velocity =
    .found = velocity { SIGNIFICANT($velocity_rad_s, digits: 6) }
    .expected = a positive velocity in rad/s

# The tree of links.
description-name-twice =
    .found = { $count } of that name
    .expected = one
description-nameless =
    .found = one without a name
    .expected = a name
description-too-many-links =
    .found = { $links } links
    .expected = at most { $most }
description-carried-twice =
    .found = { $count } joints that carry it
    .expected = one
description-several-roots =
    .found = the roots { $roots }
    .expected = one tree with one root link
description-all-a-cycle =
    .found = a cycle of joints
    .expected = one tree with one root link
description-without-links =
    .found = no link
    .expected = one tree with one root link
description-link-in-cycle =
    .found = a cycle of joints
    .expected = a chain from the root link '{ $root }'

# Frames between which the arm is.
description-frame = { $file }: frame
description-named-frame = { $file }: frame '{ $frame }'
description-unknown-frame =
    .found = '{ $frame }'
    .expected = one of the links { $links }
description-no-chain =
    .found = no chain of joints from '{ $base }' to it
    .expected = one
description-no-moving-joint =
    .found = no moving joint between '{ $base }' and it
    .expected = at least one
