# Names: bodies are told apart by them.
tools-named-like-obstacle =
    .found = the name of an obstacle or a zone
    .expected = a name of its own
tools-named-like-link =
    .found = the name of a link of the URDF
    .expected = a name of its own
tools-named-like-payload =
    .found = the name of the payload's box
    .expected = a name of its own

# What a tool weighs and where that stands.
tools-value-beside-links =
    .found = a value beside links
    .expected = links of the URDF or the tool's own values, not both
tools-without-value =
    .found = no such key
    .expected = { $keys }, or links of the URDF
tools-links-massless =
    .found = links without mass
    .expected = links whose <inertial> the URDF states, or { $keys }
tools-inertia =
    .found = mass { SIGNIFICANT($mass_kg, digits: 6) }, first_moment ({ $first_moment_kg_m }), inertia ({ $inertia_kg_m2 })
    .expected = values that a rigid body can have (pseudo-inertia positive definite)
tools-outside-box =
    .found = a centre of mass at ({ $com_m }) m, { FIXED($distance_m, digits: 3) } m outside the box
    .expected = a box that contains the tool
tools-too-heavy-for-joint =
    .found = { SIGNIFICANT($torque_n_m, digits: 4) } N m on '{ $joint }' at home, with the links
    .expected = tools that the joint can hold, { SIGNIFICANT($effort_n_m, digits: 4) } N m (limit effort of the URDF)

# Links of the URDF behind the sensor frame.
tools-link-not-behind-sensor =
    .found = '{ $link }'
    .expected =
        links behind the sensor frame '{ $frame }', { $count ->
            [0] of which there are none
           *[other] { $links }
        }
tools-link-twice =
    .found = '{ $link }', which is in tools.{ $tool } already
    .expected = each link in one tool, once
tools-links-of-none =
    .found = '{ $frame }' with the links { $links } behind it, which the sensor feels and no tool has
    .expected = a tool with them ([tools.NAME] that names them in links), or a sensor frame behind them
