# The verdict.
estimation-mass = { $decimals ->
    [0] { FIXED($mass_kg, digits: 0) } kg (±{ FIXED($half_width_kg, digits: 0) } kg, 95 %)
    [1] { FIXED($mass_kg, digits: 1) } kg (±{ FIXED($half_width_kg, digits: 1) } kg, 95 %)
    [2] { FIXED($mass_kg, digits: 2) } kg (±{ FIXED($half_width_kg, digits: 2) } kg, 95 %)
    [3] { FIXED($mass_kg, digits: 3) } kg (±{ FIXED($half_width_kg, digits: 3) } kg, 95 %)
    [4] { FIXED($mass_kg, digits: 4) } kg (±{ FIXED($half_width_kg, digits: 4) } kg, 95 %)
    [5] { FIXED($mass_kg, digits: 5) } kg (±{ FIXED($half_width_kg, digits: 5) } kg, 95 %)
   *[other] { FIXED($mass_kg, digits: 6) } kg (±{ FIXED($half_width_kg, digits: 6) } kg, 95 %)
}
estimation-all-determined = The payload has { estimation-mass }; all ten inertial parameters are determined.
estimation-inertia-not-determined = The payload has { estimation-mass }; mass and first moment are determined, the inertia is not (the motion does not excite the inertia enough).
estimation-inertia-not-determined-standing = The payload has { estimation-mass }; mass and first moment are determined, the inertia is not ({ estimation-standing }).
estimation-partly-determined = The payload has { estimation-mass }; not determined: { $missing }.
estimation-nothing-determined = The payload is not determined: { $reason }.
# Why a parameter is not determined.
estimation-standing = static poses only: the inertia is not excited
estimation-no-rotation = no rotation about { $axis }
estimation-no-rotation-of-two = no rotation about { $axis } or { $other }
estimation-two-reasons = { $rotation }; { $reason }
estimation-mass-uncertain = too few different poses to tell the weight from the sensor's offset; its standard uncertainty would be { SIGNIFICANT($std_kg, digits: 2) } kg against { SIGNIFICANT($scale_kg, digits: 2) } kg, the size that matters
estimation-first-moment-uncertain = gravity came from too few directions to tell the first moment about { $axis } from the offset; its standard uncertainty would be { SIGNIFICANT($std_kg_m, digits: 2) } kg m against { SIGNIFICANT($scale_kg_m, digits: 2) } kg m, the size that matters
estimation-inertia-uncertain = too little angular acceleration; { estimation-inertia-size }
estimation-inertia-uncertain-about = hardly any angular acceleration about { $axes }; { estimation-inertia-size }
estimation-inertia-size = its standard uncertainty would be { SIGNIFICANT($std_kg_m2, digits: 2) } kg m2 against { SIGNIFICANT($scale_kg_m2, digits: 2) } kg m2, the size that matters
# Why nothing at all is determined.
estimation-too-few-still = too few motionless samples, and no motion that could be used instead
estimation-rows-at-rest = one row in { MILLI($period_s, digits: 0) } ms is too slow to tell how it moved between: { $used } of { $rows } rows, those at rest, were used alone; log faster to see the inertia
estimation-turned-about = positions are missing: the sensor is taken to have turned about one place at rest, { FIXED($distance_m, digits: 2) } m (standard uncertainty { FIXED($std_m, digits: 2) } m) from its origin; log positions, or hold still in several poses, to know better
estimation-place-uncertain = positions are missing, and the place that the sensor turned about is not known well enough
estimation-too-short = { FIXED($lasts_s, digits: 2) } s are too short to say anything
estimation-no-motion = the recording has neither joints nor poses beside the wrench
# What should be known before the numbers are used.
estimation-motion-broken = rows are lost or written again for so long at a time that nothing can be said of the motion: mass and first moment are those of the holds
estimation-residual-above-noise = the residual exceeds the sensor's noise, most in { $channel } ({ FIXED($times, digits: 1) } times): something that the model leaves out; the uncertainties were widened, but an error that repeats is not noise
estimation-not-converged = the estimation did not come to rest: the motion does not tell apart what it has to find; the numbers are not to be relied on
estimation-no-such-body = the data alone asked for a body that cannot exist; the nearest one that can was taken
estimation-noise-of-residual = no motionless part long enough to measure the sensor's noise: it was taken from the residual
estimation-saturated = the sensor reached the end of its range in { $channels }
estimation-base-tilt = the base is not level: { DEGREES($angle_rad, digits: 2) } deg; taken into account
estimation-wrench-late = the wrench is { MILLI($late_s, digits: 1) } ms late (±{ MILLI($half_width_s, digits: 2) } ms, 95 %) against the joints; taken into account
estimation-wrench-early = the wrench is { MILLI($early_s, digits: 1) } ms early (±{ MILLI($half_width_s, digits: 2) } ms, 95 %) against the joints; taken into account
estimation-gears-accounted = the arm swings on its gears as sound arms do (softest joint { FIXED($softest_nm_per_rad, digits: 0) } N m/rad); taken into account
estimation-drift-accounted = { $drift }; taken into account
estimation-drift = the sensor's offset drifted: { $channels }
estimation-no-drift = no drift of the sensor's offset beyond its noise
estimation-drift-of-force = { $channel } { SIGNIFICANT($range_n, digits: 2) } N
estimation-drift-of-torque = { $channel } { SIGNIFICANT($range_n_m, digits: 2) } N m
estimation-transfers-alone = there was no rotation about { $axes }: { $parameters } rest on the transfers alone, and no rotation that was left out verifies them
estimation-effect-left-out = the twin's effect could not be accounted for, { $reason }
# The uncertainty budget: what contributes to it, and what was assumed because nobody has stated it.
estimation-source-repeatability = repeatability
estimation-source-sensor-gain = sensor gain
estimation-source-sensor-crosstalk = cross-talk
estimation-source-joint-zeros = joint zeros
estimation-source-sensor-mount = sensor mounting
estimation-source-gravity = gravity
estimation-source-twin = twin
estimation-assumed-gain = the sensor's calibration is not stated: a gain uncertainty of 1 % of the load is assumed (enter the certificate's figure under sensor.calibration)
estimation-assumed-crosstalk = the sensor's cross-talk is not stated: 0.5 % of the range at full load is assumed (enter the certificate's figure under sensor.calibration)
estimation-assumed-gravity = where the cell stands is not stated: 0.015 m/s² are assumed for local gravity (enter latitude and elevation under site)
estimation-assumed-zeros = the uncertainty of the joint zeros is not stated: 0.05 deg is assumed (enter zero_std_rad under robot)
estimation-assumed-mount = the uncertainty of the sensor's mounting is not stated: 0.1 deg is assumed (enter mount_std_rad under sensor)
estimation-no-reference =
    .found = no reference in any of the runs
    .expected = runs that name one (payload_reference), or no prior
estimation-different-references =
    .found = references that differ from run to run
    .expected = one payload with one reference
