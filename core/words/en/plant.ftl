# Where. $file is the URDF.
plant-inertial-parameters = inertial parameters
plant-links-on-joint = { $file }: links on joint '{ $joint }'
plant-effort-of-joint = { $file }: joint '{ $joint }': limit effort
plant-payload-with-fault = payload with a fault
# What the simulated robot cannot be built of.
plant-no-rigid-body =
    .found = { $phi }
    .expected = those that a rigid body can have
plant-no-effort =
    .found = no value
    .expected = a torque above 0 N m for the simulated drive
plant-effort-not-positive =
    .found = { SIGNIFICANT($effort_n_m, digits: 4) } N m
    .expected = a torque above 0 N m for the simulated drive
plant-no-mass =
    .found = no mass
    .expected = a payload with mass
