# The words for commands and states of a run, for other messages. Commands are those of the API, states those of PackML.
runs-command = { $command }
runs-state = { $state }

# Why a run did not come through, or why it stands.
runs-command-asked =
    { $command ->
        [stop] stopped by { PERSON($who) }.
        [abort] aborted by { PERSON($who) }.
       *[other] { runs-command } by { PERSON($who) }.
    }
runs-stopped-by-nobody = stopped by somebody who was not signed in, at { $address }.
runs-cancelled = cancelled by { PERSON($who) }.
runs-cancelled-because = cancelled by { PERSON($who) }: { $why }
runs-ended = the run was ended.
runs-shut-down = the service was shut down; the robot was stopped.
runs-service-ended = the service ended while the run was in { runs-state }; the robot was stopped. Check the cell, then clear the run.
runs-server-gone = the server is gone; the robot was stopped. Start the service and clear the run.
runs-journal-not-writable = what happens to the run could not be written ({ $reason }); the robot was stopped. Make room on the disk.
runs-folder-not-writable = the run's folder could not be written ({ $reason }); the robot was stopped. Make room.
runs-folder-not-made = the run's folder could not be made ({ $reason }); nothing has moved. Make room, then make a new run.
runs-release-not-kept = the release could not be written, so nothing has moved; look at the database and the disk, then make a new run.
runs-control-process-lost = the control process ended with code { $exit_code }; its robot got no more commands. See the log.
runs-control-process-not-started = the control process could not be started; nothing has moved. See the log.
runs-planner-lost = the planning process ended unexpectedly; start a new run.

# What does not go with a run's state.
runs-unknown = run: there is none called "{ $run }". List what there is and ask again.
runs-command-not-possible = run { $run }: { runs-command } is not possible in { runs-state }; legal commands here: { $commands }
runs-command-impossible = run { $run }: { runs-command } is not possible in { runs-state }; legal commands here: none
runs-no-plan = run { $run }: there is no plan yet, it is in { runs-state }; wait until it is Idle
runs-no-result = run { $run }: there is no result, it is in { runs-state }
runs-no-result-because = run { $run }: there is no result, it is in { runs-state } ({ $cause })
runs-no-recording = run { $run }: has no recording, it is in { runs-state }; there is one once the robot has moved and stopped
runs-no-report = run { $run }: has no report, it is in { runs-state }; a report comes with a run that is Complete
runs-recording-open = run { $run }: its control process still closes the recording; ask again in some seconds
runs-nothing-left = run { $run }: there is nothing to go on with; it is in { runs-state } and has finished { $finished_steps } steps. Begin a new run
runs-recording-not-there = run { $run }: its recording is not there (yet); ask again in some seconds, or begin a new run
runs-accepted-already = run { $run }: was accepted already, by { PERSON($who) }; a result is accepted once
runs-nothing-to-stop = cell "{ $cell }": no run has its robot, so there is nothing to stop
runs-no-common-frame = cell "{ $cell }": does not say how its sensor is mounted (sensor.mount), so runs of two cells have no frame in common

# Orders that do not go with the cell.
runs-speed-not-allowed = The speed limit of the run is { SIGNIFICANT($speed_m_s, digits: 6) } m/s (speed_m_s); this cell allows { SIGNIFICANT($least_m_s, digits: 6) } to { SIGNIFICANT($most_m_s, digits: 6) } m/s
runs-start-of-other-robot = start_rad has { $given } joint positions; this robot has { $joints } joints
runs-cell-without-payload =
    .found = no payload in cell "{ $cell }"
    .expected = one that the simulated robot can carry; add it to cell.toml
runs-payload-unknown =
    .found = "{ $payload }"
    .expected = one of { $payloads }, which cell "{ $cell }" knows

# Control of a cell, and commands that come late.
runs-control-taken = control of cell "{ $cell }": { PERSON($holder) } has it; ask them to let go of it
runs-control-free = control of cell "{ $cell }": nobody has it; take control (POST /api/control) and answer its stamps
runs-control-elsewhere = control of cell "{ $cell }": { PERSON($holder) } has it with fence { $fence }, not { PERSON($who) } with { $sent_fence }
runs-control-asked = control of cell "{ $cell }": { PERSON($who) } has asked for it already; one asks at a time
runs-control-not-asked = control of cell "{ $cell }": nobody asks for it with this request any more
runs-control-overtaken = control of cell "{ $cell }": somebody was faster; look who has it now, then ask again
runs-command-without-control = command { runs-command }: needs control of cell "{ $cell }"; send `sent` with your fence, number and stamp
runs-command-repeated = command number { $number }: not above the last one, { $last_number }; it is repeated or out of order
runs-command-late = command stamp: { FIXED($age_s, digits: 3) } s old (0 to { SIGNIFICANT($limit_s) } s allowed); send the newest stamp you got

# Releases.
runs-plan-void = plan { $plan }: void, the plan or the cell has changed since; look at the plan again (GET plan)
runs-offer-foreign = offer: not made for this plan by this service; look at the plan again (GET plan) and release what it shows
runs-offer-old = offer: { FIXED($age_s, digits: 0) } s old (limit { FIXED($limit_s, digits: 0) } s); look at the plan again and release what it shows
runs-disk-too-full = disk: { FIXED($free_mb, digits: 0) } MB are free where runs are recorded, this one needs up to { FIXED($needed_mb, digits: 0) } MB; make room, then release it again

# Who watches, and who is told.
runs-watcher-too-slow = a message did not leave within { SIGNIFICANT($limit_s) } s
runs-watcher-behind = more than { $events } events were waiting
runs-stamp-malformed = an answer is fence, number, stamp_s, page_age_s
runs-webhook-unknown = webhook: there is none called "{ $webhook }". List what there is and ask again.
runs-delivery-refused = the receiver answered with HTTP { $status }
runs-delivery-failed = no answer from this address: { $error } { $reason }
