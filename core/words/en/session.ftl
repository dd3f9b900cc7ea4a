# What was late, so that the robot is on hold.
session-late-network = no answer from the console for { session-late }: the connection was late or is lost; { session-keeps-its-place }
session-late-page = the console's page has not responded for { session-late }: the tablet is too busy, or the page stands still; { session-keeps-its-place }
session-late-service = no sign of life from the service for { session-late }: its computer is too busy, or it was stopped; { session-keeps-its-place }
session-late-control-process = the control process got no time for { session-late }: its computer is too busy; { session-keeps-its-place }
session-late-store = the database has not taken what happened for { FIXED($value, digits: 0) } s (limit { FIXED($limit, digits: 0) } s); the robot was stopped and keeps its place, and nothing is lost. Resume the run when the database is back.
session-late-sensor = the wrench has not changed for { session-late }; { session-keeps-its-place }
session-late-robot = the robot's state came after { session-late }; { session-keeps-its-place }
session-late = { MILLI($value) } ms (limit { MILLI($limit) } ms)
session-keeps-its-place = the robot was stopped and keeps its place. Resume the run when the cause is gone.
session-pause-asked = the robot was asked to pause; it keeps its place until it is told to go on.
session-hold-expired = nobody has been in control of the robot for { FIXED($value, digits: 0) } s while it was on hold (limit { FIXED($limit, digits: 0) } s); the run was ended. Begin the rest of it as a new run.
# Commands that the simulated robot refuses.
session-command-after-stop = a command after a stop; call release() when it is safe to go on.
session-command-not-finite = a command of { $count } joint positions, { $not_finite } of them not finite: expected { $joints } finite joint positions; the robot was stopped.
session-command-out-of-limits = joint { $joint }: commanded position { FIXED($value, digits: 4) } rad (limit { FIXED($limit, digits: 4) } rad); the drives refused it and stopped. Check the plan's joint limits.
session-command-too-far = joint { $joint }: commanded { FIXED($step_rad, digits: 5) } rad away in one period, { FIXED($value, digits: 3) } rad/s (limit { FIXED($limit, digits: 3) } rad/s); the drives refused it and stopped. Start from the robot's present q_cmd.

# What a driver finds before a robot moves.
session-no-package =
    .found = a driver whose package '{ $module }' cannot be loaded ({ $reason })
    .expected = pip install "heft[{ $extra }]" on the computer that runs the robot
session-no-mount =
    .found = nothing that says where the sensor is on the flange
    .expected = sensor.mount (xyz_m, rpy_rad): without it the robot's kinematics cannot be held against the controller's
session-wrong-model = the robot at { $host } calls itself { $found }, and { $at } expects { $expected }; nothing has moved. Connect the cell's robot, or correct session.model and the URDF.
session-wrong-serial = the arm at { $host } has the serial number { $found }, and { $at } expects { $expected }; nothing has moved. Connect the cell's arm, or correct session.serial after its zones and obstacles were checked for this one.
session-wrong-firmware = the controller has version { $found }, and { $at } expects { $expected }; nothing has moved. If the update is meant, try the cell at reduced speed and correct session.firmware.
session-unknown-firmware = the controller has version { $found }; this driver knows { $supported }. Nothing has moved. Update the controller.
session-wrong-joint-count = the controller has { $found } joints, the cell's URDF { $expected }; nothing has moved. Connect the cell's robot or correct the URDF.
session-limit-lower = joint { $joint }: the controller stops at { DEGREES($found) }°, the URDF allows down to { DEGREES($expected) }°; nothing has moved. Draw the URDF's limit in, or widen the controller's.
session-limit-upper = joint { $joint }: the controller stops at { DEGREES($found) }°, the URDF allows up to { DEGREES($expected) }°; nothing has moved. Draw the URDF's limit in, or widen the controller's.
session-limit-speed = joint { $joint }: the controller allows { FIXED($found, digits: 2) } rad/s, the cell { FIXED($expected, digits: 2) } rad/s; nothing has moved. Lower robot.velocity_rad_s in the cell, or allow more in the controller's safety settings.
session-kinematics-differ = the controller has its flange { MILLI($distance_m, digits: 1) } mm (limit { MILLI($limit_m, digits: 1) } mm) and { DEGREES($angle_rad, digits: 2) }° (limit { DEGREES($limit_rad, digits: 2) }°) from where the cell's URDF has it
session-joints-swapped = { session-kinematics-differ }; with the joints { $first } and { $second } swapped they agree. Nothing has moved. Correct the order of the joints in the URDF.
session-joint-sign = { session-kinematics-differ }; with the sign of joint { $joint } changed they agree. Nothing has moved. Turn the axis of that joint round in the URDF.
session-wrong-kinematics = { session-kinematics-differ }; nothing has moved. Check the URDF (its calibration, too), session.base, sensor.mount, and that the controller's tool centre point is what it says.

# A Universal Robots arm.
session-not-reached = nobody answers at { $host } ({ $reason }); nothing has moved. Check that the robot is on, the cable, session.host, and that no firewall is between.
session-not-ready = the robot at { $host } cannot be moved as it is: { $why }
session-link-lost = no sample from the robot at { $host } for { MILLI($value) } ms; its own watchdog has stopped it after { MILLI($limit) } ms. Check the line between this computer and the controller, and begin again.
session-flange-elsewhere = the controller has its flange { MILLI($value, digits: 1) } mm (limit { MILLI($limit, digits: 1) } mm) and { DEGREES($angle_rad, digits: 2) }° from where the cell's URDF has it; the robot was stopped. A joint of the URDF turns the other way round, or its lengths are another arm's.
session-payload-beyond-limit = the controller is set to a payload of { FIXED($found, digits: 2) } kg, and the cell's arm carries { FIXED($expected, digits: 2) } kg; nothing has moved. Correct the payload of the controller, or robot.payload_limit_kg.
session-ur-rtde-refused = the controller at { $host } does not take what Heft needs of RTDE ({ $what }: { $answer }); nothing has moved. Where it says IN_USE, another program writes the same registers: end it, or the fieldbus that uses them. Where it says NOT_FOUND, update PolyScope to 5.10 or newer.
session-ur-not-remote = the robot at { $host } is not in remote control; nothing has moved. Switch the teach pendant to remote control.
session-ur-program-not-begun = the robot at { $host } has not begun Heft's program within { FIXED($limit_s, digits: 0) } s; nothing has moved. Look for a message on the teach pendant, and whether remote control is on.
session-ur-protective = the controller made a protective stop. See on the teach pendant what caused it, unlock it there, and begin again.
session-ur-emergency = an emergency stop is pressed. Release it when it is safe, switch the robot on, and begin again.
session-ur-safeguard = a safeguard stop is active: a door, a light curtain or a scanner. Clear it, and begin again.
session-ur-recovery = the controller is in recovery mode: a joint is outside its safety limits. Move it back on the teach pendant, and begin again.
session-ur-violation = the controller stopped for a violation of its safety limits. Read its log, restart the safety system, and begin again.
session-ur-fault = the controller reports a fault. Read its log, restart the robot, and begin again.
session-ur-not-running = the robot is not switched on or its brakes are not released (robot mode { $value }). Switch it on on the teach pendant.
session-ur-slider = the speed slider is at { PERCENT($value) } %: the robot cannot follow at its own speed. Set it to 100 %; the cell's limits keep it slow.
session-ur-paused = the program was paused on the teach pendant. Begin again; a run is put on hold in Heft.
session-ur-program-ended = Heft's program on the controller has ended: it was stopped there, or no sign of life of Heft came in time. Begin again; where nobody stopped it, the computer was too busy.
session-ur-remote-lost = the robot was taken out of remote control, so its program has ended. Switch back to remote control, and begin again.
session-ur-payload-changed = the payload of the controller was changed from { FIXED($limit, digits: 3) } to { FIXED($value, digits: 3) } kg, or its centre of mass; it zeroes its force/torque sensor by that, so the robot was stopped and nothing is recorded across it. Begin again.
session-payload-moves = the robot at { $host } moves; nothing was written. Stop it, and begin again.
session-payload-program-runs = a program runs or is paused on the controller at { $host }, and it may move the robot any moment; nothing was written. Stop it, and begin again.
session-payload-set-meanwhile = the controller at { $host } has another payload than was shown; nothing was written. Somebody else sets it; begin again.
session-payload-differs = the controller at { $host } has not the payload that was written: { $differences }. Do not move the robot; set it on the teach pendant, and look for a message there.
session-payload-difference = { $name } is { SIGNIFICANT($read, digits: 6) } { $unit } where { SIGNIFICANT($sent, digits: 6) } was sent
session-payload-unknown = the line to the controller at { $host } was lost ({ $reason }) after the payload was sent: nobody knows whether it was taken. Look on the teach pendant before the robot moves.
session-sensor-axes = between two poses the force changed in another direction than gravity: { PERCENT($value) } % of the change point elsewhere (limit { PERCENT($limit) } %); the robot was stopped. Correct the sensor's axes: sensor.mount (rpy_rad), or robot.sensor_frame in the URDF.
session-sensor-sign = between two poses the force changed the other way round, as if the load had { FIXED($value, digits: 2) } kg; the robot was stopped. The sensor says what acts on the robot, not on the load, or the other way round: turn session.wrench_acts_on round.
