# What the path of a program cannot be
requirement-unreadable =
    .found = nothing that can be read ({ $reason })
    .expected = a CSV file with a header, the time in s and the joint positions in rad
requirement-no-numbers =
    .found = something else
    .expected = { $columns } numbers: the time in s, then every joint's position in rad
requirement-no-rows =
    .found = fewer than two rows
    .expected = a header and rows of { $columns } numbers: the time in s, then every joint's position in rad
requirement-time-stands =
    .found = { FIXED($time_s, digits: 3) } s after { FIXED($before_s, digits: 3) } s
    .expected = times that rise
requirement-too-long =
    .found = a path of { FIXED($duration_s, digits: 0) } s
    .expected = at most { FIXED($limit_s, digits: 0) } s; the first column is the time in seconds
requirement-beyond-limits =
    .found = joint { $joint } at { FIXED($value_rad, digits: 3) } rad
    .expected = { FIXED($lower_rad, digits: 3) } to { FIXED($upper_rad, digits: 3) } rad; angles are in radians
requirement-no-payload =
    .found = an answer without all ten parameters
    .expected = one that says what the robot carries

# What may be off, and what then happens
requirement-mass = mass
requirement-centre-of-mass = centre of mass
requirement-inertia = inertia
requirement-criterion-joint-torque = joint { $joint } sees { FIXED($threshold_nm, digits: 1) } N m that nobody exerts
requirement-criterion-tcp-force = the sensor frame sees { FIXED($threshold_n, digits: 1) } N that nobody exerts
requirement-criterion-guiding-force = the arm pushes with { FIXED($threshold_n, digits: 1) } N while it is guided by hand
requirement-criterion-mass = the { FIXED($threshold_kg, digits: 3) } kg that the maker allows are reached
requirement-criterion-centre-of-mass = the { MILLI($threshold_m, digits: 1) } mm that the maker allows are reached
requirement-motion-brisk = Along { FIXED($motion_s, digits: 0) } s of moves between random configurations, each as fast as the cell's limits allow.
requirement-motion-program = Along the program's { FIXED($motion_s, digits: 0) } s of motion.
requirement-assumed = The cell states no threshold of contact ([thresholds] in cell.toml): 20 N at the sensor frame are assumed.

# Whether an answer is good enough
requirement-no-answer = No answer to judge: name one with --result.
requirement-not-determined = Whether it is good enough cannot be judged: { $names } not determined.
requirement-no-body = Whether it is good enough cannot be judged: no payload was identified.
requirement-good-enough = Good enough for this cell: { SIGNIFICANT($margin, digits: 7) } times more exact than needed; { $decides } decides.
requirement-not-good-enough = Not good enough for this cell: { $name } may be off by { $error }, its interval is ± { $half_width }.
requirement-together-not-good-enough = Not good enough for this cell: all uncertainties together use { PERCENT($used, digits: 0) } % of what is allowed; { $decides } decides.
requirement-title = Good enough for what
requirement-used = With 95 % probability the error stays below { PERCENT($used, digits: 1) } % of what it takes until { $criterion }.
requirement-allowed = { $group }: may be off by { $error } until { $criterion }.
requirement-allowed-any = { $group }: nothing limits it.
requirement-source = Thresholds: { $source }.
requirement-parameter-com = centre of mass along { $axis }
requirement-parameter-moment = inertia about { $axis }
requirement-parameter-product = product of inertia { $axes }
requirement-kg = { SIGNIFICANT($value_kg, digits: 7) } kg
requirement-mm = { SIGNIFICANT($value_mm, digits: 7) } mm
requirement-kg-m2 = { SIGNIFICANT($value_kg_m2, digits: 7) } kg m²
