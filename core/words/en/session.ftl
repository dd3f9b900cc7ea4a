# What was late, so that the robot is on hold.
session-late-network = no answer from the console for { session-late }: the connection was late or is lost; { session-keeps-its-place }
session-late-page = the console's page has not responded for { session-late }: the tablet is too busy, or the page stands still; { session-keeps-its-place }
session-late-service = no sign of life from the service for { session-late }: its computer is too busy, or it was stopped; { session-keeps-its-place }
session-late-control-process = the control process got no time for { session-late }: its computer is too busy; { session-keeps-its-place }
session-late-store = the database has not taken what happened for { FIXED($value, digits: 0) } s (limit { FIXED($limit, digits: 0) } s); the robot was stopped and keeps its place, and nothing is lost. Resume the run when the database is back.
session-late-sensor = the wrench has not changed for { session-late }; { session-keeps-its-place }
session-late-robot = the robot's state came after { session-late }; { session-keeps-its-place }
session-late = { MILLI($value) } ms (limit { MILLI($limit) } ms)
session-keeps-its-place = the robot was stopped and keeps its place. Resume the run when the cause is gone.
session-pause-asked = the robot was asked to pause; it keeps its place until it is told to go on.
session-hold-expired = nobody has been in control of the robot for { FIXED($value, digits: 0) } s while it was on hold (limit { FIXED($limit, digits: 0) } s); the run was ended. Begin the rest of it as a new run.
# Commands that the simulated robot refuses.
session-command-after-stop = a command after a stop; call release() when it is safe to go on.
session-command-not-finite = a command of { $count } joint positions, { $not_finite } of them not finite: expected { $joints } finite joint positions; the robot was stopped.
session-command-out-of-limits = joint { $joint }: commanded position { FIXED($value, digits: 4) } rad (limit { FIXED($limit, digits: 4) } rad); the drives refused it and stopped. Check the plan's joint limits.
session-command-too-far = joint { $joint }: commanded { FIXED($step_rad, digits: 5) } rad away in one period, { FIXED($value, digits: 3) } rad/s (limit { FIXED($limit, digits: 3) } rad/s); the drives refused it and stopped. Start from the robot's present q_cmd.
