# The words for kinds of jobs and how far they are, for other messages.
jobs-kind = { $kind }
jobs-state = { $state }

jobs-work-lost = the process that did it ended unexpectedly; ask for it again. The service's log may know more.
jobs-unknown = { jobs-kind }: there is none called "{ $job }". List what there is and ask again.
jobs-over = { jobs-kind } { $job }: it is { jobs-state }; only what waits or runs can be cancelled

# What a diagnosis leaves, and the motion that it proposes.
jobs-no-overlay = diagnosis { $job }: has nothing to overlay, it is { jobs-state }; a done one has, if there was enough to compare
jobs-no-report = diagnosis { $job }: has no report, it is { jobs-state }; a report comes with a diagnosis that is done
jobs-no-cell = diagnosis { $job }: its recording was made in no cell of this service; upload it again with ?cell=
jobs-upload-of-other-cell = This recording was made in the cell "{ $found }", not in "{ $cell }". Choose that cell, or “Another robot”.
jobs-upload-of-other-robot = This recording is of another robot than that of the cell "{ $cell }". Choose “Another robot”: it is diagnosed without that cell's twin.
jobs-recording-gone = diagnosis { $job }: its recording is gone; diagnose another run
jobs-payload-unknown = diagnosis { $job }: payload "{ $payload }" is none that cell "{ $cell }" knows; make a run with one it knows
jobs-payload-unnamed = diagnosis { $job }: its payload has no name, so cell "{ $cell }" does not know it; make a run with one it knows
jobs-payload-differs = diagnosis { $job }: was made with payload "{ $payload }", not with "{ $given_payload }"; put "{ $payload }" back on
jobs-no-motion-yet = diagnosis { $job }: is { jobs-state }; only one that is done proposes a motion
jobs-no-motion-proposed = diagnosis { $job }: proposes no motion; it leaves nothing open that one could settle
jobs-no-motion-asked = diagnosis { $job }: asks for no motion but for { $motion }
jobs-motion-refused = diagnosis { $job }: its motion was not planned ({ $refusal }); diagnose the recording again, in a cell that leaves room
jobs-motion-not-planned = diagnosis { $job }: its motion was not planned; diagnose the recording again, in a cell that leaves room
jobs-robot-changed = diagnosis { $job }: cell "{ $cell }" has changed since the recording: it has another robot; make a new run there
jobs-gravity-changed = diagnosis { $job }: cell "{ $cell }" has changed since the recording: gravity at the base is ({ $gravity_m_s2 }) m/s2, it was ({ $recorded_m_s2 }); make a new run there

# The twins.
jobs-effect-not-in-twin = effect in the twin: there is none called "{ $effect }". List what there is and ask again.
jobs-no-effect-yet = diagnosis { $job }: is { jobs-state }; an effect can be taken from one that is done
