# Stops by the guard. $value and $limit are what was measured or commanded, and what it was compared with.
guard-state-not-finite = the robot's state is not finite; the robot was stopped. Check the connection to robot and sensor and start again.
guard-command-not-finite = the commanded position is not finite; the robot was stopped. Check the connection to robot and sensor and start again.
guard-state-stale = the robot's clock went on by { MILLI($value, digits: 2) } ms in one period (expected { MILLI($limit, digits: 2) } ms), its state is stale; the robot was stopped. Check the connection to the robot and start again.
guard-state-late = the robot's state came after { MILLI($value, digits: 1) } ms (limit { MILLI($limit, digits: 1) } ms); the robot was stopped. Take load off the computer or its network and start again.
guard-joint-position = joint { $joint } is at { FIXED($value, digits: 4) } rad (limit { FIXED($limit, digits: 4) } rad); the robot was stopped. Move it back by hand guiding and plan again.
guard-joint-position-commanded = joint { $joint } was commanded to { FIXED($value, digits: 4) } rad (limit { FIXED($limit, digits: 4) } rad); the robot was stopped. Plan again.
guard-joint-speed = joint { $joint } moves at { FIXED($value, digits: 3) } rad/s (limit { FIXED($limit, digits: 3) } rad/s); the robot was stopped. Plan again.
guard-joint-speed-commanded = joint { $joint } was commanded at { FIXED($value, digits: 3) } rad/s (limit { FIXED($limit, digits: 3) } rad/s); the robot was stopped. Plan again.
guard-speed = { $body } moves at { FIXED($value, digits: 3) } m/s (limit { FIXED($limit, digits: 3) } m/s); the robot was stopped. Plan again.
guard-speed-commanded = { $body } was commanded at { FIXED($value, digits: 3) } m/s (limit { FIXED($limit, digits: 3) } m/s); the robot was stopped. Plan again.
guard-force = { $channel } of { $sensor } is { FIXED($value, digits: 2) } N (range { FIXED($limit, digits: 2) } N); the robot was stopped. Check for contact, or take a lighter payload or a larger sensor.
guard-torque = { $channel } of { $sensor } is { FIXED($value, digits: 2) } N m (range { FIXED($limit, digits: 2) } N m); the robot was stopped. Check for contact, or take a lighter payload or a larger sensor.
guard-joint-off-command = joint { $joint } is { FIXED($value, digits: 4) } rad from its command (limit { FIXED($limit, digits: 4) } rad); the robot was stopped. Check the joint's controller and the load settings and start again.
guard-wrench-frozen = the wrench has not changed for { FIXED($value, digits: 3) } s (limit { FIXED($limit, digits: 3) } s), a live sensor shows its noise; the robot was stopped. Check the sensor's connection and start again.

# Distances: today's, and that of the place where the robot would stand if it braked now.
guard-too-close = { $first } is { FIXED($value, digits: 5) } m from { $second } (limit { FIXED($limit, digits: 3) } m); the robot was stopped. Plan again.
guard-too-close-to-zone = { $first } is { FIXED($value, digits: 5) } m from { $second } (limit { FIXED($limit, digits: 3) } m); the robot was stopped. Clear the zone and start again.
guard-too-close-to-obstacle = { $first } is { FIXED($value, digits: 5) } m from { $second } (limit { FIXED($limit, digits: 3) } m); the robot was stopped. Check where it stands and plan again.
guard-would-stop-too-close = { $first } would stop { FIXED($value, digits: 5) } m from { $second } (limit { FIXED($limit, digits: 3) } m); the robot was stopped. Plan again.
guard-would-stop-too-close-to-zone = { $first } would stop { FIXED($value, digits: 5) } m from { $second } (limit { FIXED($limit, digits: 3) } m); the robot was stopped. Clear the zone and start again.
guard-would-stop-too-close-to-obstacle = { $first } would stop { FIXED($value, digits: 5) } m from { $second } (limit { FIXED($limit, digits: 3) } m); the robot was stopped. Check where it stands and plan again.
