# The reports of a run and of a diagnosis, and what their pictures say.

# Both
report-and = and
report-or = or
report-unit = unit
report-reference = reference
report-error = error
report-limit = limit
report-interval = ± (95 %)
report-frame = Sensor frame, inertia about the sensor origin.
report-not-determined = not determined

# A motion, as recordings and plans name it
report-phase-hold = hold:{ $axis }
report-phase-rotation = rotate:{ $axis }
report-phase-transfer = transfer:{ $axis }
report-part-hold = hold { $axis }
report-part-rotation = rotation { $axis }
report-part-transfer = transfer { $axis }
report-part-wave = wave { $axis }
report-part-between = transfer
report-part-home = home

# Head and foot
report-title = Payload { $payload }
report-title-unnamed = Payload
report-from-recording = from a recording
report-made-by = Made by Heft { $version }. Heft is not a safety function (safety_rated: false). Distances and speeds are computed from joint positions by a program that nobody has certified; people are protected by the safety functions of the robot and the cell, never by this report or the program behind it.

# Facts
report-mass = Mass
report-com = Centre of mass
report-com-note = sensor frame; ± { $half_widths } mm (95 %)
report-moments = Principal moments
report-moments-note = g m², about the centre of mass
report-moments-impossible = g m², about the centre of mass; no rigid body has these parameters
report-base-tilt = Tilt of the base
report-base-tilt-note = about base x and y, against nominal gravity; ± { $half_widths }
report-delay = Delay of the wrench
report-delay-note = against the joints; ± { $half_width } ms (95 %)
report-accounted = Effects accounted for
report-accounted-note = as the cell's twin has them; they change the mass by { MILLI($mass_kg, digits: 1) } g
report-smallest-distance = Smallest distance
report-nearest = to { $name }; limit { FIXED($limit_m, digits: 3) } m
report-nearest-beyond-first = to { $name }; limit { FIXED($limit_m, digits: 3) } m; { FIXED($beyond_m, digits: 3) } m without the links that only the first joint moves
report-largest-speed = Largest speed
report-largest-speed-note = of any point; limit { FIXED($limit_m_s, digits: 3) } m/s
report-restarts = Restarts
report-restarts-none = the guard never stopped the robot
report-restarts-some = the guard stopped the robot

# Inertial parameters
report-parameters = Inertial parameters
report-parameters-note = ± after Heft's value is half of the 95 % interval; after the paper's, one standard deviation as its Eq. (8)-(10) state it.
report-reference-source = Reference: { $source }.
report-paper = paper's method
report-ours = Heft
report-paper-error = error of the paper's
report-our-error = error of Heft's
report-outside = In colour: the reference is outside the 95 % interval. Either the reference or the model of the measurement is not right.
report-budget = Where the uncertainty comes from
report-budget-note = Share of each parameter's variance. The repeatability is what this recording leaves open (type A); everything else stays the same from run to run (type B) and no repetition removes it. Units as in the table above.
report-budget-measured = measured
report-budget-stated = stated
report-budget-assumed = assumed
report-budget-repeats = repeats within ± (95 %)
report-budget-total = all in, ± (95 %)
report-workpiece-alone = Workpiece alone
report-workpiece-note = The table above is of the whole that the sensor feels. Without { $tools }; ± is half of the 95 % interval, with the tools' stated uncertainty in it.
report-tool = { $title } ({ SIGNIFICANT($mass_kg, digits: 4) } kg)
report-workpiece = workpiece

# Sensor
report-sensor = Sensor
report-sensor-note = Residual: measured minus reconstructed wrench. Where it exceeds the noise, something acts that the model leaves out.
report-offset = offset
report-residual-rms = residual, rms
report-noise-std = noise, std
report-ratio = ratio
report-unseen = Motions that the fit did not see
report-rotation-about = rotation about { $axis }
report-unseen-holds = A { $motion } that was left out is predicted to { $rms } (rms), { FIXED($ratio) } times the { $expected } that noise and the prediction's own uncertainty make one expect: the result holds on it.
report-unseen-fails = A { $motion } that was left out is predicted to { $rms } (rms), { FIXED($ratio) } times the { $expected } that noise and the prediction's own uncertainty make one expect: the result does not hold on it, something acts that the model leaves out.
report-force-and-torque = { SIGNIFICANT($force_n, digits: 2) } N and { SIGNIFICANT($torque_n_m, digits: 2) } N m

# Pictures
report-wrench = Wrench, measured and reconstructed
report-wrench-caption = Wide grey line: measured, offset taken off. Thin line: reconstructed from the identified parameters. Below each: the residual in standard deviations of the noise, with the band of ±3. Shaded: rotations about the sensor axis named above.
report-rotations = Rotations
report-rotations-caption = Angular velocity and acceleration about the rotation's axis, in grey about the other two, and the torque about that axis: measured (wide, grey) and reconstructed (thin).
report-about-axis = about sensor axis { $axis }
report-rotation-time = time in the rotation, s
report-residual-sigma = residual, σ
report-distance = Distance
report-distance-caption = Smallest distance of robot and payload box to obstacles and protected zones, without the links that only the first joint moves: theirs hardly changes.
report-distance-axis = distance, m
report-distance-limit = limit { FIXED($limit_m, digits: 3) } m

# Start configurations
report-starts = Start configurations
report-starts-note = Obstacles are grey, protected zones dashed, the payload box outlined. x y z: sensor axes; the named axis points along gravity (+) or against it (−). Dotted arrows: where a load that comes off at the start would fly.
report-scene = Robot in start configuration { $axis }, { FIXED($clearance_m, digits: 3) } m from { $nearest }
report-throw = throw
report-start-clear = { FIXED($clearance_m, digits: 3) } m clear (nearest: { $nearest }), manipulability { FIXED($manipulability, digits: 3) }
report-start-clear-turning = { FIXED($clearance_m, digits: 3) } m clear, { FIXED($turning_m, digits: 3) } m in the rotation (nearest: { $nearest }), manipulability { FIXED($manipulability, digits: 3) }
report-start-joints = joints { $angles }
report-start-throw = a load that comes off passes { $zone } at { FIXED($distance_m) } m ({ FIXED($speed_m_s) } m/s)

# Second opinion
report-opinion = Second look at the plan
report-opinion-note = { $samples } set points measured once more before the release, by code and a collision library that the planner does not use.
report-opinion-least = least
report-opinion-between = between
report-opinion-where = where
report-opinion-left-out = Pairs of which nothing is asked
report-opinion-when = { $part }, { FIXED($time_s, digits: 1) } s
report-opinion-fastest = fastest point
report-opinion-corner = a corner of { $body }
report-opinion-lost-load = a load that comes off
report-body-payload = payload
report-body-floor = floor
report-opinion-flight = its flight - zone { $zone }
report-pair-environment = obstacles, zones and floor
report-pair-first-link = first link against obstacles, zones and floor
report-pair-mount = first links against what the robot is mounted on
report-pair-payload = payload against links
report-pair-links = links against links
report-pair-near = near each other by construction
report-pair-joined = left out

# Origin
report-origin = How this came about
report-recording = Recording
report-samples = { $count } samples
report-rate = { FIXED($span_s, digits: 1) } s, { SIGNIFICANT($rate_hz, digits: 4) } per second on average
report-measured = Measured
report-wrist-wrench = wrist wrench
report-joint-torques = joint torques
report-with-joints = with joint positions
report-with-poses = with poses of the sensor
report-planning = Planning
report-robot-time = Robot time
report-estimation = Estimation
report-seed = Seed
report-seed-note = of planning and simulation
report-source = Source of the recording: { $source }

# Diagnosis: head and facts
report-gap-none = No gap that matters
report-gap-explained = Gap explained
report-gap-ambiguous = Gap explained in more than one way
report-gap-unknown = Gap of unknown cause
report-gap-not-enough = Too little to say anything
report-gap-under = Diagnosis of the gap between a recording and the simulation of the same run
report-gap-under-with-twin = Diagnosis of the gap between a recording and the simulation of the same run. The cell's twin already has: { $effects }
report-gap-to-do = What to do
report-gap-for-payload = For the payload
report-gap = Gap
report-gap-noise-is-one = noise alone is 1
report-gap-with-effect = Gap with the effect added
report-gap-with-best-effect = Gap with the best effect
report-gap-on-unseen = on unseen motions
report-gap-probability = Probability
report-gap-of-unknown = of an unknown effect
report-gap-of-effect = of { $effect }
report-gap-closure = Closure
report-gap-closure-interval = 95 %: { PERCENT($low) } to { PERCENT($high) } %
report-gap-largest-in = Largest in
report-gap-during = during { $phase }
report-gap-during-at-stage = during { $phase }; stage: { $stage }
report-gap-stage-sensor = sensor
report-gap-stage-timing = timing
report-gap-stage-mounting = mounting
report-gap-stage-kinematics = kinematics
report-gap-stage-payload = payload
report-gap-stage-environment = environment
report-gap-stage-actuation = actuation
report-gap-made-by = Worked out by Heft { $version } in { FIXED($seconds, digits: 1) } s. A diagnosis is an advice: it changes neither the recording nor the cell, and Heft is not a safety function (safety_rated: false).

# What to do
report-gap-do-nothing = Nothing needs to be added to the simulation.
report-gap-record-again = Record again, with what is lacking.
report-gap-add-none = Add no effect to the simulation: none of them is the cause.
report-gap-add-none-look = Add no effect to the simulation: none of them is the cause. Look at { $channel } during { $phase } first.
report-gap-if-it-is = If it is { $effect }: { $advice }
report-gap-settle-by-motion = Settle first which it is: see the next experiment below.
report-gap-settle-by = Settle first which it is: { $splits }
report-gap-settle = Settle first which it is.

# Where
report-gap-where = Where the gap lies
report-gap-share = share
report-gap-all-bands = all bands
report-gap-band = { SIGNIFICANT($low_hz, digits: 6) } to { SIGNIFICANT($high_hz, digits: 6) } Hz
report-gap-heat-note = Large: rms of recording minus simulation as a multiple of its noise. Small: share of the whole gap. Both are of averaged rows, whose noise is low; so they are larger than the gap, which is of single samples. The { $count } largest places are listed, { PERCENT($share) } % of the gap; empty places hold less each.
report-gap-heat-note-of-bands = Large: rms of recording minus simulation as a multiple of its noise, in “all bands” that of the loudest band. Small: share of the whole gap. Both are of averaged rows, whose noise is low; so they are larger than the gap, which is of single samples. The { $count } largest places are listed, { PERCENT($share) } % of the gap; empty places hold less each.
report-gap-over-time = Share over time, %
report-gap-start = start
report-gap-end = end of the recording
report-gap-by-direction = By direction and by the axis that points up or down, times noise
report-gap-positive = turning positively
report-gap-negative = turning negatively
report-gap-still = standing still
report-gap-axis-down = { $axis } down
report-gap-axis-up = { $axis } up
report-gap-on-joints = On the joints' side
report-gap-tracking = tracking error, moving
report-gap-torque = torque not accounted for

# Which effect
report-gap-which = Which effect causes it
report-gap-effects = Effects
report-gap-probability-column = probability
report-gap-closure-column = closure (95 %)
report-gap-gap-after = gap after
report-gap-size-column = size, ± one standard deviation
report-gap-percent-range = { PERCENT($low) } to { PERCENT($high) } %
report-gap-no-effect = no effect
report-gap-not-in-library = something that the library does not have
report-gap-at-bound = { $parameter } (at its bound)
report-gap-more-parameters = and { $count } more, less clear
report-gap-closure-note = Closure: the share of the gap above the noise that goes once the effect is in the simulation.
report-gap-no-effects-note = An effect that matters would stand here.
report-gap-effect-closes = { $effect } { PERCENT($closure) } %
report-gap-likely = In nine of ten cases like this it is one of these: { $effects }.
report-gap-others =
    Not shown: { $count ->
        [one] 1 other effect
       *[other] { $count } other effects
    }, together { $share }. They would have closed: { $closed }.
report-gap-others-and-less = Not shown: { $count } other effects, together { $share }. They would have closed: { $closed }, the rest less.
report-gap-fewer-parameters = Closure alone does not decide: of explanations that predict alike, the one with fewer parameters is the likelier.
report-gap-other-pairs =
    Not shown: { $count ->
        [one] 1 other combination
       *[other] { $count } other combinations
    }, together { $share }; the closest ({ $effects }) closes { PERCENT($closure) } %.
report-gap-ties = What this recording cannot tell apart
report-gap-apart = { FIXED($sigma, digits: 1) } σ apart
report-gap-settled-by = It would be settled by: { $splits }

# Next experiment
report-gap-next = Next experiment
report-gap-takes = It takes { FIXED($time_s, digits: 0) } s.
report-gap-planned = It is planned in the cell.
report-gap-not-planned = It is not yet planned: { $reason }
report-gap-pair = { $first } from { $second }
report-gap-tells-apart = It tells apart { $pairs }: { FIXED($before, digits: 1) } σ now, { FIXED($after, digits: 0) } σ expected with both recordings.

# How far it shrinks
report-gap-shrinks = How far the gap shrinks
report-gap-from-to = From { FIXED($before) } to { FIXED($after) } times the noise, on motions that the fit did not see.
report-gap-size = How large the gap is
report-gap-times = { FIXED($before) } times the noise. A gap matters from 2 on, or where it moves the payload.
report-gap-times-and-after = { FIXED($before) } times the noise; { FIXED($after) } with all that was detected added to the simulation. A gap matters from 2 on, or where it moves the payload.
report-gap-by-channel = Gap of each channel before and after
report-gap-noise = noise
report-gap-axis = gap, noise = 1
report-gap-bars-effect = Upper bar: before. Lower bar: with the effect added; in colour where more than twice the noise remains. Dashed: noise alone. Each of these motions was predicted from the others: { $motions }.
report-gap-bars-best-effect = Upper bar: before. Lower bar: with the best effect of the library added; in colour where more than twice the noise remains. Dashed: noise alone. Each of these motions was predicted from the others: { $motions }.
report-gap-bars-detected = Upper bar: before. Lower bar: with all that was detected added; in colour where more than twice the noise remains. Dashed: noise alone. Each of these motions was predicted from the others: { $motions }.
report-gap-worst = The worst motion: { $channels } during { $phase }
report-gap-overlay = Measured and simulated wrench
report-gap-rest-axis = rest, σ
report-gap-key-measured = measured, offset taken off
report-gap-key-before = simulated before
report-gap-key-after = simulated with the effect added
report-gap-key-simulated = simulated
report-gap-overlay-note = Below: measured minus simulated in standard deviations of the noise, with the band of ±3. In colour: more than noise can be.

# Payload
report-gap-payload = Payload
report-gap-payload-moved = Payload before and after
report-gap-payload-note = ± one standard deviation.
report-gap-payload-moved-note = Change: after minus before, as a share of the mass, of the first moment's norm, of the largest moment of inertia; and in 95 % intervals of both values together, where up to 1 is no significant difference. In colour: a change that matters.
report-gap-payload-untrusted = “After” is with the best effect of the library, which is not the cause: neither column can be trusted.
report-gap-before = before
report-gap-after = after
report-gap-change = change
report-gap-in-intervals = × the interval
report-gap-value = value

# Beside it
report-gap-also = Seen elsewhere than in the wrench
report-gap-also-note = It explains no gap between simulation and recording, and is judged by a measure of its own.
report-gap-side-joints = at the joints
report-gap-side-reading = in the sensor's readings
report-gap-side-reference = against the reference payload
report-gap-times-expected = { $side }; { FIXED($times, digits: 1) } times what is stated or tolerated
report-gap-does-not-matter = It does not matter.
report-gap-minor = Detected, but not material
report-gap-limits = What this recording cannot say

# What the joints' torques say
report-joints = Joints
report-joints-note = What the torques say of the joints themselves: friction, by how much each torque reads too much with its 95 % interval, and what nothing explains, root mean square.
report-joints-coulomb = Coulomb, N m
report-joints-viscous = viscous, N m s/rad
report-joints-gain = gain off, %
report-joints-residual = unexplained, N m
report-joints-windows = windows
