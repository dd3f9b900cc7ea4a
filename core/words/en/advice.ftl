# What a person should do about an effect, with its figures.
advice-base-tilt = Level the base: turn it by { DEGREES($first_rad, digits: 2) } deg about { $first_axis } and { DEGREES($second_rad, digits: 2) } deg about { $second_axis } of the base frame; or turn the direction of gravity in the cell by the same angles.
advice-base-tilt-leans = Fasten the base, or put it on stiff feet: it leans by up to { DEGREES($lean_rad, digits: 2) } deg as the arm moves. Then level it.
advice-base-tilt-sinks = Put the base on firm ground and fasten it: it sank by { DEGREES($sunk_rad, digits: 2) } deg from { FIXED($at_s, digits: 1) } s on. Then level it.
advice-cable-drag = Free the hose or cable: it pulls with { FIXED($pull_n, digits: 1) } N at the start, changes by { FIXED($stiffness_n_per_m, digits: 1) } N per metre and rubs with { FIXED($friction_n, digits: 1) } N.
advice-cable-drag-twisting = Free the hose or cable: it pulls with { FIXED($pull_n, digits: 1) } N at the start, changes by { FIXED($stiffness_n_per_m, digits: 1) } N per metre and rubs with { FIXED($friction_n, digits: 1) } N, and it twists with { FIXED($twist_nm_per_rad, digits: 2) } N m per rad.
advice-external-contact = Keep the payload clear: something pushed it with up to { FIXED($force_n, digits: 1) } N from { FIXED($begin_s, digits: 1) } to { FIXED($end_s, digits: 1) } s; leave that part out or run again.
advice-gear-ripple = Turn joint { $joint } at another speed while measuring: its gear errs by { DEGREES($amplitude_rad, digits: 4) } deg { FIXED($per_turn, digits: 0) } times per turn.
advice-joint-backlash = Have the gear of joint { $joint } adjusted: it has { DEGREES($play_rad, digits: 3) } deg of play from side to side.
advice-joint-elasticity = Enter the joints' stiffness in the cell's twin (joint { $joint }: { FIXED($stiffness_nm_per_rad, digits: 0) } N m/rad, it gives by up to { DEGREES($give_rad, digits: 2) } deg), or use encoders on the link side.
advice-joint-elasticity-rigid = Enter the joints' stiffness in the cell's twin, or use encoders on the link side.
advice-joint-friction = Warm the joints up by a few minutes of motion, have those looked at that rub more than they did, and state the friction that is left in cell.toml (robot.friction).
advice-joint-offset = Calibrate the zero of joint { $joint }, which is off by { DEGREES($error_rad, digits: 2) } deg (all joints: { $zeros }).
advice-joint-offset-uneven = Centre or replace the encoder of joint { $joint }, which errs by { DEGREES($error_rad, digits: 2) } deg once per turn.
advice-joint-offset-warming = Let the arm move for some minutes before it is measured: the zero of joint { $joint } creeps by { DEGREES($change_rad, digits: 2) } deg within { FIXED($within_s, digits: 0) } s.
advice-kinematic-lag = Record unfiltered joint positions, or shift the joints' time stamps { MILLI($lag_s, digits: 1) } ms earlier.
advice-kinematic-lag-joints = Record the positions of all joints at one instant and unfiltered: joint { $joint } is { MILLI($lag_s, digits: 1) } ms late, the one that is least late { MILLI($least_s, digits: 1) } ms.
advice-kinematic-lag-opens = Record unfiltered joint positions: their filter opens with speed, they are { MILLI($lag_s, digits: 1) } ms late at rest and half of it at { SIGNIFICANT($speed_rad_s, digits: 2) } rad/s.
advice-payload-loose = Fasten the loose part of the payload: about { PERCENT($mass_share) } % of its mass gives by { MILLI($sag_m) } mm under its weight and swings at { FIXED($frequency_hz, digits: 1) } Hz.
advice-payload-loose-fluid = Fill or empty what holds fluid in the payload: it creeps to the low side within { FIXED($settling_s, digits: 1) } s and moves the first moment by { MILLI($first_moment_kg_m, digits: 1) } kg mm to either side.
advice-payload-loose-hanging = Fasten the loose part of the payload: about { PERCENT($mass_share) } % of its mass hangs { MILLI($sag_m) } mm below where it is held and swings at { FIXED($frequency_hz, digits: 1) } Hz.
advice-payload-loose-hinge = Fasten the part of the payload that turns on a hinge: its heavy side goes down. Its first moment about the hinge is { MILLI($first_moment_kg_m, digits: 1) } kg mm.
advice-payload-loose-stops = Fasten the loose part of the payload: it slides from stop to stop and moves the first moment by { MILLI($first_moment_kg_m, digits: 1) } kg mm to either side.
advice-payload-loose-vessel = Fasten what swings in the payload, or fill its vessel: about { PERCENT($mass_share) } % of the mass swings at { FIXED($frequency_hz, digits: 1) } Hz, until a wall stops it { DEGREES($wall_rad, digits: 0) } deg from the middle.
advice-payload-mass-gained = Check the payload: at { FIXED($at_s, digits: 1) } s it gained { MILLI($mass_kg) } g at ({ MILLI($x_m) }, { MILLI($y_m) }, { MILLI($z_m) }) mm from the sensor; identify it again afterwards.
advice-payload-mass-lost = Check the payload: at { FIXED($at_s, digits: 1) } s it lost { MILLI($mass_kg) } g at ({ MILLI($x_m) }, { MILLI($y_m) }, { MILLI($z_m) }) mm from the sensor; identify it again afterwards.
advice-payload-mismatch = Check that the right payload is mounted and replace the reference by the identified parameters.
advice-payload-mismatch-heavier = Check that the right payload is mounted and replace the reference by the identified parameters (it is { MILLI($mass_kg) } g heavier).
advice-payload-mismatch-lighter = Check that the right payload is mounted and replace the reference by the identified parameters (it is { MILLI($mass_kg) } g lighter).
advice-payload-shift = Clamp the payload more firmly: at { FIXED($at_s, digits: 1) } s it slipped by { MILLI($first_moment_kg_m, digits: 1) } kg mm; identify it again afterwards.
advice-payload-shift-of-whole = Clamp the payload more firmly: at { FIXED($at_s, digits: 1) } s it slipped by { MILLI($first_moment_kg_m, digits: 1) } kg mm (the whole payload by { MILLI($distance_m, digits: 1) } mm); identify it again afterwards.
advice-payload-shift-several = Clamp the payload more firmly: from { FIXED($first_s, digits: 1) } to { FIXED($last_s, digits: 1) } s it slipped several times, by up to { MILLI($first_moment_kg_m, digits: 1) } kg mm; identify it again afterwards.
advice-sample-dropout = Match the recorder's rate to the sensor's or relieve its bus: { $held_share ->
    [0] { PERCENT($lost_share, digits: 1) } % of the samples are lost.
   *[other] { $lost_share ->
        [0] { PERCENT($held_share, digits: 1) } % of the samples are held.
       *[other] { PERCENT($held_share, digits: 1) } % of the samples are held and { PERCENT($lost_share, digits: 1) } % are lost.
    }
}
advice-sensor-creep = Wait about { FIXED($wait_s, digits: 0) } s after a change of load before taring or measuring: { $channel } creeps by { PERCENT($creep_share, digits: 2) } % of the change within { FIXED($within_s, digits: 0) } s.
advice-sensor-crosstalk = Load the sensor's calibration matrix anew or have it recalibrated: { $load } of { $of_channel } shows as { $shown } in { $in_channel }.
advice-sensor-crosstalk-products = Have the sensor calibrated with loads in several channels at once: { $first } times { $second } adds { PERCENT($share, digits: 1) } % of its load to { $in_channel }.
advice-sensor-drift = Let the sensor warm up for 20 min and tare it just before the run: its offset went { $drift } in { FIXED($within_s, digits: 0) } s.
advice-sensor-gain = Have the sensor recalibrated with known weights in both directions: against the other channels { $channel } is off by { PERCENT($positive_share, digits: 1) } % where it is positive and by { PERCENT($negative_share, digits: 1) } % where it is negative.
advice-sensor-gain-jump = Have the sensor checked for a gauge or a wire that has come off, and recalibrated: at { FIXED($at_s, digits: 1) } s { $channel } changed its gain by { PERCENT($change_share, digits: 1) } %.
advice-sensor-gain-swing = Look at the sensor's supply, which goes up and down every { FIXED($cycle_s, digits: 0) } s (a charger or a heater on the same line): the gain of { $channel } is off by { PERCENT($gain_share, digits: 1) } % in the mean, and swings by { PERCENT($swing_share, digits: 1) } %.
advice-sensor-gain-warming = Let the sensor warm up for 20 min before the run, and have it recalibrated if that does not help: { $channel } changed its gain by { PERCENT($change_share, digits: 1) } % in { FIXED($within_s, digits: 0) } s.
advice-sensor-hysteresis = Check the bolts of the sensor's flanges for slip, else approach every pose from the same side: { $channel } differs by { PERCENT($height_share, digits: 2) } % of full scale between loading and unloading.
advice-sensor-interference = Lead the sensor's cable away from motor and mains cables and ground its shield at one end, to be rid of the line at { FIXED($frequency_hz, digits: 1) } Hz.
advice-sensor-lowpass = Switch the sensor's filter off or raise it well above { FIXED($cutoff_hz, digits: 0) } Hz; it delays by { MILLI($delay_s) } ms.
advice-sensor-noise = Check the sensor's supply, shield and cable ({ $channel } is { FIXED($times, digits: 1) } times as noisy as stated), or state the higher noise and hold longer.
advice-sensor-nonlinearity = Have the sensor's linearity checked with known weights: { $channel } is bent by { PERCENT($bend_share, digits: 1) } % at full scale.
advice-sensor-nonlinearity-knee = Look for dirt or a cover that touches inside the sensor from { $load } on, and have its linearity checked with known weights: from there { $channel } has a slope that is off by { PERCENT($change_share, digits: 1) } %.
advice-sensor-nonlinearity-polynomial = Have the sensor's linearity checked with known weights, pulled and pushed: { $channel } is bent by { PERCENT($bend_share, digits: 1) } % at { $load }.
advice-sensor-offset-step = Check the sensor's plug and cable and tare it: { FIXED($at_s, digits: 1) } s after the start its offset jumped by { $step }.
advice-sensor-quantization = Choose the sensor's finest resolution or a smaller range: { $channel } comes in steps of { $step }; until then move a little during the holds.
advice-sensor-rotation = Correct the sensor frame in the URDF: turn it by { DEGREES($x_rad, digits: 2) }, { DEGREES($y_rad, digits: 2) } and { DEGREES($z_rad, digits: 2) } deg about its x, y and z axes, or remount the sensor.
advice-sensor-rotation-rocks = Tighten the bolts of the sensor: it rocks by up to { DEGREES($slip_rad, digits: 2) } deg to either side with the torque on it.
advice-sensor-saturation-above = Choose a larger range of the sensor or a lighter payload: { $channel } is clipped above { $clipped_at } (without the offset), the run needs { $needed }.
advice-sensor-saturation-below = Choose a larger range of the sensor or a lighter payload: { $channel } is clipped below { $clipped_at } (without the offset), the run needs { $needed }.
advice-sensor-saturation-bridge = Choose a larger range of the sensor or a lighter payload: its bridges are at their ends in { PERCENT($share) } % of the run, and { $channel } loses most by it.
advice-sensor-translation = Move the sensor frame in the URDF by { MILLI($x_m, digits: 1) }, { MILLI($y_m, digits: 1) } and { MILLI($z_m, digits: 1) } mm along its x, y and z axes.
advice-sensor-translation-split = Have the sensor calibrated: two of its torques are taken about origins that lie { MILLI($apart_m, digits: 1) } mm apart along { $axis }.
advice-structure-vibration = Find what shakes at { FIXED($frequency_hz, digits: 1) } Hz (a machine beside the robot, a table that is not firm, a blow), or hold longer and measure when it is quiet.
advice-time-delay = Stamp wrench and joints with one clock, or set a delay of { MILLI($delay_s, digits: 1) } ms in the recorder.
advice-time-delay-grows = Stamp wrench and joints with one clock, or set the clocks by each other: the wrench comes { MILLI($per_minute_s, digits: 1) } ms later with every minute.
advice-time-delay-slips = Stamp wrench and joints with one clock, without a buffer between them: the delay grows by { MILLI($swing_s, digits: 1) } ms and falls back every { FIXED($cycle_s, digits: 1) } s.
advice-time-delay-wanders = Stamp wrench and joints with one clock, and let nothing between them wait: the delay wanders between { MILLI($least_s, digits: 1) } and { MILLI($most_s, digits: 1) } ms.
advice-tool-flexibility = Stiffen the tool or smooth the motion: it rings at { FIXED($frequency_hz, digits: 1) } Hz with { PERCENT($damping_ratio) } % of critical damping.
advice-torque-offset = Set the torque sensors of the joints to zero anew, as the maker of the robot describes it.
advice-velocity-lag = Record unfiltered joint velocities or leave them out: these follow the positions { MILLI($lag_s, digits: 1) } ms late.
