# A KUKA LBR over FRI.
kuka-no-sensor =
    .found = no sensor
    .expected = session.sensor (driver, host): the arm has no force/torque sensor at its flange, and identification needs one. Without one, the payload can be had from joint torques: two recordings of the controller, heft import, heft identify LOADED --without EMPTY (docs/joint-torques.md)
kuka-no-pad =
    .found = nothing that says how the arm stands: this version of the interface tells no pose of its own
    .expected = session.pad (q_deg, xyz_mm, abc_deg): move the arm to a pose with no axis near zero and read axes and flange off the smartPAD
kuka-pad-hides-sign =
    .found = a pose at which the flange would be the same with axis { $first } turned round
    .expected = a pose of session.pad with every axis some 10 degrees from zero and from each other
kuka-pad-hides-order =
    .found = a pose at which the flange would be the same with the axes { $first } and { $second } swapped
    .expected = a pose of session.pad with every axis some 10 degrees from zero and from each other
kuka-silent = no message from the robot at { $host } on port { $port } of this computer within { FIXED($limit_s, digits: 0) } s{ $strange ->
    [none] {""}
   *[other] , but some from { $strange }
  }; nothing has moved. Start the Sunrise application, and check that it sends to this computer's address and to this port, session.host, and that no firewall is between.
kuka-no-line = the line to the robot at { $host } on port { $port } of this computer cannot be used ({ $reason }); nothing has moved. Check session.host, session.listen and session.port, whether another program has this port, and that the controller's version of FRI is 1.11 to 2.7.
kuka-period = the controller at { $host } sends every { MILLI($found_s, digits: 0) } ms, and session.send_period_ms says every { MILLI($expected_s, digits: 0) } ms; nothing has moved. Correct one of them.
kuka-multiplier = the controller at { $host } wants an answer to every { $found }th message only; nothing has moved. Set the receive multiplier of the Sunrise application to 1.
kuka-joint-beyond = joint { $joint } stands at { DEGREES($found) }°, and the cell's URDF ends at { DEGREES($expected) }°; nothing has moved. Is it the cell's arm? Correct the URDF, or move the arm into its range.
kuka-too-fast-for-t1 = it is in T1, where no point may be faster than { FIXED($limit, digits: 2) } m/s, and the cell allows { FIXED($value, digits: 2) } m/s. Switch it to automatic mode, or lower limits.cartesian_speed_m_s.
kuka-other-commands = the motion of the Sunrise application takes no joint positions (command mode { $mode }, overlay { $overlay }; Heft needs 1 and 1). Use FRIJointOverlay with ClientCommandMode.POSITION (JOINT_POSITION in FRI 2).
kuka-other-control = the Sunrise application moves in another control mode ({ $mode }; Heft needs 0, position control). Begin the motion with PositionControlMode: in impedance control the arm gives way to its load.
kuka-line-too-slow = the connection to the robot at { $host } has not become good enough within { FIXED($limit_s, digits: 0) } s (quality { $quality } of 3, 2 needed); nothing has moved. Use a cable of its own and a computer without other work, or a longer send period.
kuka-no-motion-yet = the Sunrise application of the robot at { $host } has begun no motion that Heft could lead within { FIXED($limit_s, digits: 0) } s; nothing has moved. See on the smartPAD what it waits for: it has to begin a positionHold with FRIJointOverlay when the connection is good.
kuka-not-begun = the robot at { $host } has not taken over Heft's commands within { FIXED($limit_s, digits: 0) } s; nothing has moved. Look for a message on the smartPAD.
kuka-closed-yet = the robot at { $host } has closed the session; nothing has moved. Start the Sunrise application again.
kuka-commanded-already = the robot at { $host } is still in a motion that somebody leads; nothing has moved. End that program, and begin again.
kuka-link-lost = no message from the robot at { $host } for { MILLI($value) } ms; its controller ends the motion by itself. Check the line between this computer and the controller, and whether the Sunrise application still runs, and begin again.
kuka-starved = the robot was sent nothing for { MILLI($value) } ms (limit { MILLI($limit) } ms) while it moved; it was stopped. This computer was too busy, or the line was late. Begin again.
kuka-unheard = the controller has had no command for { MILLI($value) } ms (limit { MILLI($limit) } ms), though its messages arrive; the robot was stopped. Check the line, and that nothing between lets only one direction through.
kuka-quality = the controller finds the connection too poor (quality { $value } of 3, { $limit } needed) and lets no one command; the robot was stopped. Use a cable of its own and a computer without other work, or a longer send period. Begin again.
kuka-stop-0 = the safety controller has stopped the robot at once: an emergency stop, the enabling switch, a protective field, or a limit. See on the smartPAD what caused it, and begin again.
kuka-stop-1 = the safety controller has stopped the robot on its path: a protective field, a door, or a limit. See on the smartPAD what caused it, and begin again.
kuka-stop-2 = the safety controller asks for a standstill: a protective field, a door, or a limit. See on the smartPAD what caused it, and begin again.
kuka-closed = the controller has closed the session: the Sunrise application has ended. Find out why on the smartPAD, start it, and begin again.
kuka-ended = the motion that Heft led has ended (session state { $value }, { $limit } needed): the Sunrise application was paused or stopped, or the controller refused a command. See on the smartPAD, and begin again.
kuka-operation = somebody has changed the mode of operation (T1, T2, automatic) on the smartPAD; the robot was stopped. Begin again.
kuka-drives = the drive of axis A{ $axis } is off or goes off (state { $value }, { $limit } needed); the robot was stopped. See on the smartPAD why, and begin again.
kuka-control = somebody has changed the control mode (to { $value }; Heft needs { $limit }, position control); the robot was stopped. Begin again.
kuka-counted = the robot's line: { $missed } messages not seen, quality { $quality } of 3 at worst.
kuka-external = before anything moved the controller did not explain { FIXED($torque, digits: 1) } N m at joint { $joint }: its load data, or something that touches the arm.
