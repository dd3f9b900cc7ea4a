procedure-interrupted = interrupted after { FIXED($moved_s, digits: 1) } s of motion; the robot was stopped.
procedure-interrupted-recorded = interrupted after { FIXED($moved_s, digits: 1) } s of motion; the robot was stopped and the recording so far closed in { $folder }.
