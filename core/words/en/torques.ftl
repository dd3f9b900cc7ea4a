# Identification from the torques of the joints, without a wrist sensor.
torques-no-payload-seen = No payload is seen: its mass would be { SIGNIFICANT($mass_kg, digits: 2) } kg (±{ SIGNIFICANT($half_width_kg, digits: 2) } kg, 95 %), which is compatible with none.
torques-no-payload = no payload is seen, so there is nothing whose inertia could be told
torques-mass-uncertain = the torques tell it only to a standard uncertainty of { SIGNIFICANT($std_kg, digits: 2) } kg against { SIGNIFICANT($scale_kg, digits: 2) } kg, the size that matters
torques-first-moment-uncertain = the torques tell the first moment about { $axis } only to a standard uncertainty of { SIGNIFICANT($std_kg_m, digits: 2) } kg m against { SIGNIFICANT($scale_kg_m, digits: 2) } kg m, the size that matters
# Why nothing at all is determined.
torques-no-torques = the recording has neither a wrench of a wrist sensor nor joint torques
torques-no-joints = the recording has joint torques but no joint positions, or no robot that they belong to
torques-arm-unknown = the URDF states no mass for what moves with { $joints }, so the arm's share of the torques is unknown; a recording without the payload (--without) takes its place
torques-too-short = the recording is too short, too slowly sampled (20 Hz at least), or full of gaps
torques-nothing-turns = no joint turns far enough in one direction (0.01 rad, faster than 0.02 rad/s) for its friction to be told from the load
torques-other-scale = the torques are { SIGNIFICANT($scale, digits: 2) } times what the motion of the arm asks for by its URDF: they may be currents, on the motor's side of the gear, of the other sign, or of another arm; tau_* is N m on the joint's side, positive where it drives the joint forward
torques-needed = a payload without a wrist sensor asks for joint positions and torques, a URDF with masses or a recording of the same arm without the payload (--without), and joints that turn
torques-of-empty = --without
torques-none-in-empty =
    .found = no joint positions or no joint torques in it
    .expected = a recording of the same arm without the payload, with both
# What should be known before the numbers are used.
torques-arm-by-urdf = the arm's own share of the torques is taken from the URDF with its uncertainty; a recording of the same arm without the payload (--without) makes the answer several times more exact
torques-arm-off = the arm differs from its URDF by { SIGNIFICANT($times, digits: 2) } times what is stated or assumed of it (link_mass_std); its uncertainty was widened by as much
torques-joints-idle = hardly anything could be used of { $joints }, which hardly turned in one direction, so that friction hides the load there
torques-gain-off = the torque of { $joint } differs from what the arm's motion asks for by { PERCENT($share) } %: its current constant, its gear ratio or its unit may be wrong
torques-outlying = { PERCENT($share) } % of the windows fit no model of arm, payload and friction and count less: contacts, or friction of another kind
torques-late = the torques are { MILLI($late_s, digits: 1) } ms late (±{ MILLI($half_width_s, digits: 1) } ms, 95 %) against the positions; taken into account
# The uncertainty budget.
torques-source-gain = torque gains
torques-source-arm = arm's model
torques-assumed-gain = the uncertainty of the torques is not stated: 8 % for each joint and 6 % for all together are assumed (enter torque_gain_std under robot)
torques-assumed-arm = the uncertainty of the URDF's masses is not stated: 10 % of each mass, 2 cm of each centre and 20 % of each moment are assumed (enter link_mass_std under robot)
torques-run-not-empty = run { $run }: is not one without the payload in cell { $cell }; name one that was ordered with empty
torques-not-together = order: { $key } does not go with { $option }; joint torques tell the payload from whole runs, compared where it is on
torques-without-beside =
    .found = a recording without the payload beside { $option }
    .expected = one of the two: it is compared with one that has the payload, when the robot has come through
