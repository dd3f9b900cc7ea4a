# What the options and files of a command cannot be
cli-folder-missing =
    .found = a folder that does not exist
    .expected = a file in an existing folder
cli-exists-already =
    .found = something that exists already
    .expected = a new name, or an empty folder
cli-kept-already =
    .found = something that exists already
    .expected = a new folder for --keep
cli-no-such-payload =
    .found = '{ $name }'
    .expected = one of { $names }
cli-no-payloads =
    .found = '{ $name }'
    .expected = a payload of the cell, which has none; add one to cell.toml
cli-experiment-without-cell =
    .found = no cell to plan it in
    .expected = --cell CELL beside it
cli-experiment-beside-others =
    .found = --from, --axes, --holds-only, --for, --empty or --without beside it
    .expected = none of these: the experiment has its own motion, from home
cli-fake-not-six-joints =
    .found = a robot of { $count } joints
    .expected = a cell whose robot has six, as those of Universal Robots
cli-fake-no-address =
    .found = { $host }, where nothing can listen ({ $reason })
    .expected = an address of this computer whose ports { $ports } are free, 127.0.0.2 say
cli-fake-not-five-to-seven-joints =
    .found = a robot of { $count } joints
    .expected = a cell whose robot has five, six or seven, as those of UFACTORY
cli-fake-not-allowed =
    .found = a port at { $host } that only administrators of this computer may listen at
    .expected = --port 5020, and session.port = 5020 in the cell
cli-fake-not-seven-joints =
    .found = a cell with { $count } joints
    .expected = seven: this arm has that many
cli-fake-sends = a KUKA LBR at { $host } sends to { $client }, port { $port }, every { $period } ms; Ctrl-C ends it.
cli-fake-serves = a { $model } (serial number { $serial }) at { $host }; Ctrl-C ends it.
cli-fake-serves-franka = a { $model } at { $host }, port { $port }, server version { $version }; Ctrl-C ends it. Its controller allows 10 rad/s² (7.5 at joint 2 of a Panda): robot.acceleration_rad_s2 of the cell has to keep that.
cli-fake-serves-ati = An ATI Net F/T box on its flange at 127.0.0.1: RDT on port { $rdt }, pages on port { $pages } (session.sensor: driver = "ati_net_ft", host = "127.0.0.1", http_port = { $pages })
cli-fake-serves-ati-alone = an ATI Net F/T box at 127.0.0.1 that holds the payload still: RDT on port { $rdt }, pages on port { $pages } (session.sensor: driver = "ati_net_ft", host = "127.0.0.1", http_port = { $pages }); Ctrl-C ends it.
cli-fake-served = { $followed } periods under command, { $missed } of them without a new command; { $late } periods began late on this computer.
cli-fake-latency = From report to command: { $median } ms in the median, { $most } ms in 99.9 %, { $worst } ms at most.
cli-from-beside-robot =
    .found = a start beside the driver '{ $driver }'
    .expected = no such option: a real robot says itself where it stands, and the plan begins there
cli-experiment-of-several =
    .found = an experiment for several recordings
    .expected = one recording: the motion continues it
cli-experiment-of-log =
    .found = an experiment for another program's log
    .expected = a recording, which the motion continues: heft import LOG --out DIR, then heft diagnose DIR
cli-log-beside-recording =
    .found = a log beside recordings
    .expected = the files of one log, or recordings: heft import LOG --out DIR makes one of the other
cli-option-of-logs =
    .found = an option of logs, and { $recording } is a recording
    .expected = recordings without it: they say themselves what they hold
cli-one-recording =
    .found = a second recording
    .expected = one: heft fuse takes several answers together, heft compare holds them against each other
cli-log-taken = Nothing speaks against it. A recording was made of { $logs } for this answer only; heft import keeps one.
cli-experiment-of-another-cell =
    .found = '{ $found }'
    .expected = '{ $cell }', the cell that is to carry it out
cli-experiment-without-motion =
    .found = none
    .expected = a motion; what it asks for is { $motion }
cli-not-seeds =
    .found = '{ $found }'
    .expected = seeds like 300,305,400-420
cli-not-xacro-argument =
    .found = '{ $found }'
    .expected = NAME:=VALUE
cli-result-unreadable =
    .found = nothing that can be read ({ $reason })
    .expected = a file that --json wrote
cli-no-result =
    .found = something else
    .expected = the answer of `heft run` or `heft identify`
cli-no-diagnosis =
    .found = something else
    .expected = the answer of `heft diagnose`
cli-twin-nominal =
    .found = '{ $effect }'
    .expected = nothing: the twin is the nominal one
cli-effect-of-twin = twin of { $cell }: effect
# How a command ends
cli-error = heft: { $error }
cli-interrupted = heft: interrupted; nothing was moving.
# While a command works
cli-planning = planning
cli-estimating = estimating
cli-fitting = fitting effects
cli-diagnosing = diagnosing { $name } ({ $number } of { $count })
cli-trials = trials
# Cells
cli-cell = cell
cli-title = title
cli-axes = axes
cli-obstacles = obstacles
cli-zones = protected zones
cli-payloads = payloads
cli-cell-unusable = { $name } cannot be used: { $flaw }
cli-cell-made = Made { $folder }; its home is pictured in { $picture }.
cli-cell-next = Next: look at cell.toml, put in what stands there, then `heft cell check { $cell }` and `heft plan { $cell }`.
cli-cell-counts = { $name }: { $wrong ->
        [0] nothing
       *[other] { $wrong }
    } wrong, { $doubtful ->
        [0] nothing
       *[other] { $doubtful }
    } doubtful.
cli-one-of-please = One of { $possible }, please.
# Twins
cli-twin-added = { $effect } added to the twin of { $cell }.
cli-twin-replaced = { $effect } replaced by the new fit in the twin of { $cell }.
cli-twin-removed = { $effect } taken out of the twin of { $cell }.
cli-twin-empty = The twin of { $cell } is the nominal one: nothing has been added to it.
cli-twin-title = Twin of { $cell }
cli-twin-caption = ± is the standard uncertainty; the gap is in units of noise
cli-twin-gap = gap before, after
cli-twin-recording = recording
cli-twin-entered = added
# Trials
cli-trial-sealed = trial { $seed }: sealed { $hash }
cli-trial-answered = trial { $seed }: planted { $planted }, size { FIXED($size, digits: 2) }; answered { $answer }: { $mark }
# Exports
cli-export-target = { $title }: { $says }
cli-export-frame = In the flange's frame, from which the controller counts; { $says }.
cli-export-lack = { $target } has no place for { $name } = { SIGNIFICANT($lost, digits: 3) } { $unit }, { FIXED($times, digits: 1) } times its uncertainty.
cli-export-mount-of-cell =
    .found = --cell or a mount beside it
    .expected = neither: the cell that is written to says how its sensor is mounted
cli-export-nothing-written =
    .found = somebody who accepts, and nothing that is written
    .expected = --write CELL beside it
cli-export-not-writable =
    .found = the target { $target }
    .expected = --target with one of { $known }: other controllers are not written to
cli-export-no-robot =
    .found = the driver '{ $driver }'
    .expected = { $expected }: a cell whose robot this target is for
cli-export-another-cell =
    .found = an answer of the cell '{ $found }'
    .expected = one of '{ $cell }', to whose robot it is to be written
cli-export-no-mass =
    .found = { FIXED($found_kg, digits: 3) } kg
    .expected = more than 0 kg
cli-export-too-heavy =
    .found = { FIXED($found_kg, digits: 3) } kg
    .expected = at most { FIXED($limit_kg, digits: 2) } kg (robot.payload_limit_kg of the cell)
cli-export-nobody =
    .found = no name
    .expected = the name of whoever has accepted the payload
cli-export-nobody-asked =
    .found = nobody who could be asked: this is no terminal
    .expected = --accepted-by with the name of whoever has accepted the payload
cli-export-table = In the flange's frame; inertia about the centre of mass. ± is half of the 95 % interval.
cli-export-now = controller has
cli-export-then = will be set to
cli-export-no-inertia = The inertia is not determined throughout; zero is written, as for a point mass. The controller then reckons with too little in fast motions.
cli-export-sensor-itself = What sits between flange and sensor, and the sensor's own flange side, is not in these numbers: the controller needs it on top.
cli-export-zeroes = The controller zeroes its force/torque sensor by this: nothing may touch the tool meanwhile, and recordings from before and after have different offsets. Do not put them together as one.
cli-export-load-beside = The controller counts it beside the end effector that is set up in Desk: what is set there and hung behind the sensor counts twice. How long it is kept no public source says: look at it after a restart.
cli-export-until-off = The controller has it until it is switched off or another is set: then it takes what is saved in UFACTORY Studio. Put it in there, too, and save it. The load in the set-up of its force/torque sensor is another one, and stays as it is.
cli-export-yes = yes
cli-export-question = To set the robot at { $host } so, type { $yes }
cli-export-declined = nothing was written: the payload was not accepted.
cli-export-written = The controller at { $host } has it now, read back; accepted by { $who }.
# Experiments and reports
cli-nothing-to-settle = There is nothing to settle: { $file } is not written.
cli-report = Report: { $file }
cli-no-run =
    .found = neither { $answer } nor { $manifest }
    .expected = an answer that --json wrote, a run's folder, or a recording's
cli-run-twice =
    .found = the same answer as { $first }, in every digit
    .expected = each run once: a run that counts twice would make the answer look more certain
cli-identifying = identifying { $folder }
