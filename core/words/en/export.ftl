# In which frame a payload is written.
export-sensor-frame = the sensor's frame: the cell does not say how the sensor is mounted on the flange (sensor.mount in cell.toml)
export-flange-frame = the flange's frame, from which the controller counts
# Units, order and frame of what each target takes.
export-ur = kg, m, kg m2; inertia about the centre of mass along the flange's axes: Ixx Iyy Izz Ixy Ixz Iyz
export-kuka-krl = kg, mm, deg, kg m2; principal moments J about the centre of mass, along axes that A B C turn from the flange's
export-kuka-sunrise = kg, mm, kg m2; moments about the centre of mass along the flange's axes, without products
export-abb = kg, mm, kg m2; principal moments about the centre of mass, along axes that a quaternion (w x y z) turns from the flange's
export-franka = kg, m, kg m2; inertia about the centre of mass along the flange's axes, nine values column by column
export-flexiv = kg, m, kg m2; inertia about the centre of mass along the flange's axes: Ixx Iyy Izz Ixy Ixz Iyz
export-xarm = kg, mm; no inertia
export-opc-ua = kg, mm, deg, kg m2; principal moments about the mounting point, along axes that A B C turn from the mounting point's
export-mujoco = kg, m, kg m2; inertia about the centre of mass along the body's axes: 11 22 33 12 13 23
export-urdf = kg, m, kg m2; inertia about the centre of mass along the link's axes: ixx ixy ixz iyy iyz izz
# What cannot be written.
export-unknown-target =
    .found = '{ $name }'
    .expected = one of { $known }
export-nothing-identified =
    .found = nothing that was identified
    .expected = a result with a payload; this one says: { $verdict }
export-not-determined =
    .found = not determined
    .expected = a value in { $unit } for { $target }; identify with a motion that excites it
export-too-large =
    .found = { SIGNIFICANT($inertia_kg_m2, digits: 4) } kg m2
    .expected = at most +-{ SIGNIFICANT($most_kg_m2, digits: 6) } kg m2, which the robot takes
# How exactly it is known, in the file as a remark or beside it.
export-uncertainty = Half-widths of 95 % intervals, along the axes of { $axes }:
export-axes-flange = the flange
export-axes-sensor = the sensor
export-uncertainty-part = { $part } +- { $half_widths }; repeats within +- { $repeats }; mostly { $mostly }
export-part-mass = mass
export-part-com = centre of mass x, y, z
export-part-inertia = inertia about the centre of mass Ixx, Ixy, Ixz, Iyy, Iyz, Izz
export-uncertainty-earlier = repeatability alone, as an earlier version knew it: calibration and the like come on top
export-uncertainty-assumed = assumed, because nobody has stated it: { $sources }
export-unknown = not determined
export-kg = { SIGNIFICANT($value_kg, digits: 2) } kg
export-mm = { SIGNIFICANT($value_mm, digits: 2) } mm
export-kg-m2 = { SIGNIFICANT($value_kg_m2, digits: 2) } kg m2
export-not-held = { $target } has no place for the uncertainty:
