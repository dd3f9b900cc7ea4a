# Alarms: what needs a person, and what to do.
alarms-run-aborted = Run aborted: { $cause }
alarms-run-aborted-do = Check the cell, then clear the run. Until then no other run begins in this cell.
alarms-sensor-lost = Force sensor: { $cause }
alarms-sensor-lost-do = Check the sensor, its cable and its power supply. Then clear the run.
alarms-robot-lost = Robot: { $cause }
alarms-robot-lost-do = Check the connection to the robot and its controller. Then clear the run.
alarms-run-held = Run on hold: { $cause }
alarms-run-held-do = Resume it or stop it. Without anybody in control it ends by itself.
alarms-run-blocked = The path is blocked by { $in_the_way }.
alarms-run-blocked-do = Clear the path. The robot resumes by itself.
alarms-run-stopped = Run stopped: { $cause }
alarms-run-stopped-do = The robot stands where it was stopped. Check it, then continue the run or start a new one.
alarms-order-waits = An order of { $sender } waits for its release.
alarms-order-waits-do = Review its plan at the cell, then release or cancel it.
alarms-store-away = The database cannot be used.
alarms-store-away-do = Check the database and its disk. Nothing can be released until it is back; what happens meanwhile is kept and written later.
alarms-disk-full = The disk is full: { FIXED($free_mb, digits: 0) } MB free.
alarms-disk-full-do = Make room in the data folder. Until then no run is released.
alarms-disk-nearly-full = The disk is nearly full: { FIXED($free_mb, digits: 0) } MB free.
alarms-disk-nearly-full-do = Make room in the data folder before runs cannot be recorded any more.
alarms-webhook-failing = { $url } does not take what it is sent, { $attempts } attempts so far: { $cause }
alarms-webhook-failing-do = Check the address and the system behind it. Messages are sent again for three days.
alarms-cell-flawed = Cell { $cell } cannot be used: { $flaw }
alarms-cell-flawed-do = Correct the cell’s files, or move the protected zone back.

# What does not go with an alarm.
alarms-unknown = alarm: none of the open ones is called "{ $alarm }". List what is open and ask again.
alarms-acknowledged-already = alarm { $alarm }: was acknowledged already, by { PERSON($who) }
