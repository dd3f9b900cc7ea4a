# Why nothing is estimated: the recording contradicts what it states of itself. $slip says what would be right instead, $units likewise.
setup-fits-better = the recording contradicts its set-up: it fits { SIGNIFICANT($times, digits: 2) } times better with { $slip }; correct that and try again
setup-mass-negative = the recording contradicts its set-up: the mass would be { SIGNIFICANT($mass_kg, digits: 3) } kg; it is positive with { $slip }; correct that and try again
setup-motion-agrees = the recording contradicts its set-up: what the payload weighs and how it resists motion belong together only with { $slip }; correct that and try again
setup-figures-agree = the recording contradicts its set-up: what it states of its sensor or payload is right only with { $slip }; correct that and try again
setup-velocities-say = the recording contradicts its set-up: its joint velocities belong to its joint positions only with { $slip }; correct the column t and try again
setup-mass-too-large = the payload would have a mass of { SIGNIFICANT($mass_kg, digits: 4) } kg; is the force in another unit than N ({ $units })?
setup-lever-too-long = the payload's centre of mass would be { SIGNIFICANT($lever_m, digits: 3) } m from the sensor; are force and torque in N and N m (and not in { $units })?
setup-force-beyond-range = { $channel } reaches { SIGNIFICANT($largest, digits: 4) } N, and the sensor's range is { SIGNIFICANT($range, digits: 3) } N; is the force in another unit ({ $units })?
setup-torque-beyond-range = { $channel } reaches { SIGNIFICANT($largest, digits: 4) } N m, and the sensor's range is { SIGNIFICANT($range, digits: 3) } N m; is the torque in another unit ({ $units })?
setup-speeds-too-high = by its clock the robot turns with { SIGNIFICANT($speed_rad_s, digits: 2) } rad/s; are t in s and angles in rad?
setup-speeds-too-low = by its clock the robot takes { SIGNIFICANT($lasts_s, digits: 3) } s and never turns faster than { SIGNIFICANT($speed_rad_s, digits: 1) } rad/s; is t in another unit than s ({ $units })?
setup-clock-too-fine = by its clock the recording has { SIGNIFICANT($rate_hz, digits: 3) } samples a second; is t in s?
setup-wrench-zero = the wrench is zero in every row: the sensor was not connected, or not recorded
setup-wrench-constant = the wrench is the same in all { $rows } rows: the sensor was not connected, or its last value was repeated
setup-channel-dead = { $channel } never changes although the payload's weight turns through it: a dead channel
setup-poses-contradict = the estimate ({ SIGNIFICANT($mass_kg, digits: 4) } kg) contradicts what the payload weighs in the recording's poses ({ SIGNIFICANT($weighed_kg, digits: 4) } kg): the motion and the wrench do not belong together, or something was touched
# What should be known before the numbers are used.
setup-rows-repeated = { PERCENT($share) } % of the rows in motion repeat the row before: joints and wrench were recorded more slowly than the clock says
setup-nothing-felt = the force changes from pose to pose by no more than its noise ({ SIGNIFICANT($change_n, digits: 2) } N): no payload, or a sensor that is not connected
setup-sampled-slowly = { SIGNIFICANT($rate_hz, digits: 2) } samples a second are too few to see accelerations: the inertia needs at least 10, better 100
# Slips, as part of a sentence: "with ...".
setup-either = { $first } or { $second }
setup-both = { $first } and { $second }
setup-wrench-sign = the opposite sign of the wrench (sensor.sign)
setup-gravity-along = gravity as [{ $gravity_m_s2 }] m/s2
setup-gravity-opposite = gravity in the opposite direction
setup-wrench-in-base = the wrench in the base's axes
setup-wrench-in-and-about-base = the wrench in the base's axes and about the base's origin
setup-torque-about-base = the torque about the base's origin
setup-torque-about-another-point = the torque about another point than the sensor's origin, [{ $shift_m }] m away from it
setup-sign-of-torque = the opposite sign of the torque
setup-force-and-torque-exchanged = the columns of force and torque exchanged
setup-axes-of-both = the columns of force and torque in the order { $axes }
setup-axes-of-force = the columns of force in the order { $axes }
setup-axes-of-torque = the columns of torque in the order { $axes }
setup-quaternions-wxyz = the quaternions in the order w, x, y, z
setup-rotation-inverted = the orientations inverted (the base in the sensor's frame)
setup-joints-in-degrees = the joint angles in degrees
setup-joints-converted-twice = the joint angles converted from degrees twice
setup-joints-reversed = the joints in reverse order
setup-joints-exchanged = the columns of { $first } and { $second } exchanged
setup-joints-shifted = { $places ->
    [one] the columns of the joints shifted by { $places } place
   *[other] the columns of the joints shifted by { $places } places
}
setup-joint-negative = the opposite sign of { $joint }
setup-all-joints-negative = the opposite sign of all joints
setup-time-in = the time in { $unit }
setup-clock-slow = a clock that runs { SIGNIFICANT($times, digits: 2) } times more slowly than recorded
setup-clock-fast = a clock that runs { SIGNIFICANT($times, digits: 2) } times faster than recorded
setup-positions-in-millimetres = the positions in mm
setup-force-in = the force in { $unit }
setup-torque-in = the torque in { $unit }
