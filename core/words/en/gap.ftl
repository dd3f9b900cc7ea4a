# The verdict in a sentence.
gap-none = Simulation and recording agree as far as it matters.
gap-explained = The gap is explained by { $effects } (stage: { $stages }).
gap-ambiguous = The gap may be explained by { $effects } (stage: { $stages }), but this recording does not settle it.
gap-unknown = There is a gap that no effect of the library explains.
gap-nothing-to-say = Nothing can be said about the gap: { $reason }.
gap-summary-and = { $said } { $more }

# Why nothing can be said.
gap-no-wrench = the recording has no wrist wrench: the gap of joint torques alone is shown by the joint side only
gap-joints-alone = There is no wrist wrench, so only the joints were looked at. { $seen }
gap-joints-two = a load that one of two recordings carries shows beside the other: heft identify LOADED --without EMPTY
gap-joints-as-ever = Nothing stands out.
gap-no-motion = the recording has neither joints nor poses
gap-too-few-poses = { $poses } poses are too few to tell a gap from noise: at least { $needed } are needed
gap-of-poses = only poses were recorded: what happens on the way between them cannot be seen
gap-noise-of-poses = the noise of a pose is not stated: what a linear sensor under any gravity would leave stands for it, and a gap of another kind may hide in that (`sensor.noise_std` states it)
gap-too-short = { FIXED($lasts_s, digits: 1) } s are too short to say anything

# Where the gap lies.
gap-largest = The gap is largest in { $channel } during { $phase } between { SIGNIFICANT($low_hz, digits: 3) } and { SIGNIFICANT($high_hz, digits: 3) } Hz: { FIXED($times, digits: 1) } times the noise, { PERCENT($share) } % of the whole gap.
gap-phase-hold = hold { $axis }
gap-phase-rotate = rotation { $axis }
gap-phase-transfer = transfer
gap-at-joints = at the joints
gap-in-readings = in the sensor's readings
gap-against-reference = against the reference payload

# What comes of it for the payload.
gap-payload-as-it-is = The payload parameters can be used as they are.
gap-payload-changed = Left out, it changes the mass by { MILLI($mass_kg, digits: 1) } g ({ PERCENT($mass_share, digits: 2) } %), the first moment by { MILLI($first_moment_kg_m, digits: 2) } g m ({ PERCENT($first_moment_share, digits: 2) } %), the inertia by up to { PERCENT($inertia_share, digits: 1) } % of its largest moment.
gap-payload-changed-but-inertia = Left out, it changes the mass by { MILLI($mass_kg, digits: 1) } g ({ PERCENT($mass_share, digits: 2) } %), the first moment by { MILLI($first_moment_kg_m, digits: 2) } g m ({ PERCENT($first_moment_share, digits: 2) } %); the inertia is not determined by this recording.
gap-payload-in-doubt = What it does to the payload cannot be told as long as its cause is not known: use these numbers with care.

# What this recording cannot say, and what would.
gap-minor = detected, but too small to matter
gap-hardly-turns = the sensor hardly turns: gravity does not tell payload from offsets here, only accelerations do
gap-moments-left = { PERCENT($share) } % of what the effect leaves of the gap lie in few motions, most of it about { FIXED($at_s, digits: 1) } s: outside of them it explains the recording, how it went there is not quite as its model has it
gap-sound-gears = the arm swings on its gears as sound arms do (softest joint { FIXED($softest_nm_per_rad, digits: 0) } N m/rad): that is taken for a part of the simulation, and joints above { FIXED($least_nm_per_rad, digits: 0) } N m/rad are not named
gap-not-shown = { $title }: { $reason }
gap-tied = with other payload parameters and offsets both predict this recording; they differ by { FIXED($distance_sigma, digits: 1) } standard deviations
gap-no-motion-splits = none of the motions at hand by itself
gap-no-cell = no cell was given to plan it in
gap-no-motion-asked = it is not a motion

# What stands against adding an effect to the twin, and what would not.
gap-not-addable =
    .found = { $against }
    .expected = { $wanted }
gap-cannot-show = a recording that cannot show { $effect } ({ $reason })
gap-wanted-shown = one that can
gap-tied-to-run = a recording from which { $effect } cannot be carried over ({ $reason })
gap-wanted-stated = one that states it
gap-not-determined = { $effect } not determined: no parameter is more than { FIXED($away_sigma, digits: 1) } standard deviations from its absence
gap-wanted-livelier = at least { SIGNIFICANT($least_sigma, digits: 2) }; a longer or livelier run shows more
gap-not-closed = { $effect } closing { PERCENT($closure) } % of the gap ({ FIXED($gap_before, digits: 3) } before, { FIXED($gap_after, digits: 3) } after, noise is 1)
gap-wanted-closed = an effect that makes the gap smaller for certain; `heft diagnose` names those that do
gap-other-cell = a recording of the cell '{ $found }'
gap-wanted-cell = '{ $cell }', whose twin it is to change
gap-other-joints = a recording of { $joints } joints
gap-wanted-joints = { $joints }, as in the cell '{ $cell }'
gap-of-other-robot = a recording of another robot
gap-wanted-robot = one of the robot of the cell '{ $cell }'
gap-wanted-addable = an effect that a twin can take
gap-earlier-version =
    .found = a diagnosis that an earlier version made
    .expected = one with all that a twin needs; diagnose the recording again
gap-not-named =
    .found = '{ $name }'
    .expected = one that the diagnosis names: { $names }
gap-names-none =
    .found = '{ $name }'
    .expected = one that the diagnosis names: it names none

# Which effects were asked for.
gap-effect-asked = effect
gap-not-on-wrench =
    .found = '{ $name }', { $title }, which does not act on the wrench
    .expected = an effect that does
gap-no-such-effect =
    .found = '{ $name }'
    .expected = { $wanted }
gap-too-many-effects =
    .found = { $count } effects at once
    .expected = one, or two or three joined by plus signs; add the others afterwards
gap-one-is-enough =
    .found = no more explained by both than by { $best } alone
    .expected = '{ $best }', if that is what was meant
gap-says-nothing =
    .found = a recording that says nothing about a gap ({ $reason })
    .expected = one of a whole run

# A proposed experiment and the recording that it continues.
gap-cell = cell { $cell }
gap-other-robot =
    .found = another robot than the recording's
    .expected = the cell of the recording
gap-other-recording =
    .found = a recording with SHA-256 { $found_sha256 }...
    .expected = the one that the experiment was proposed for, { $sha256 }...; name its folder with --recording
gap-contact = { FIXED($begin_s, digits: 1) } to { FIXED($end_s, digits: 1) } s (up to { FIXED($most_n, digits: 0) } N)
gap-contacts = Something touched the payload{ $count ->
    [one] { "" }
   *[other] { " " }{ $count } times
 }, and that explains the gap: { $contacts }.
gap-contacts-beside = The rest of the recording shows { $effects } besides.
gap-contacts-rest = Outside of that a gap of { FIXED($gap, digits: 1) } times the noise is left, which no effect of the library explains.
gap-contacts-left-out = the { PERCENT($share, digits: 0) } % of the recording in which something touched the payload: payload and remaining gap are those of the rest
gap-contact-passes = a contact passes; the simulation cannot repeat it
