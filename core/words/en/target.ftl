# What a target cannot be
target-unreadable =
    .found = { $text }
    .expected = requirement, or half-widths of 95 % intervals such as mass=0.1%,com=0.5mm,inertia=1%
target-out-of-range =
    .found = { $text }
    .expected = more than nothing, and at most 100 % or 1 m
target-without-cell =
    .found = the requirement of a cell that is not named
    .expected = --cell CELL beside it, or half-widths such as mass=0.1%,inertia=1%
target-beside-experiment =
    .found = a target beside an experiment
    .expected = one of them: an experiment is made as it was proposed
# How far it is met
target-title = What was asked for
target-requirement = what the cell requires
target-reached-home = Target reached: the robot goes home.
target-reached = Target reached.
target-reached-early = Target reached after { $made } of { $planned } motions: the robot went home { FIXED($saved_s, digits: 0) } s sooner.
target-reached-with-fewer = Target reached with { $repetitions ->
    [one] one repetition
   *[other] { $repetitions } repetitions
 } fewer: { FIXED($saved_s, digits: 0) } s saved.
target-type-b = Target not reached ({ $names }): type B is what is left, more repetitions would not help. Better figures for sensor, robot and site would.
target-open = Target not reached ({ $names }): more repetitions would help.
target-quantity = { $name }: { PERCENT($total, digits: 0) } % of what the target allows; repeatability alone { PERCENT($repeatability, digits: 0) } %, type B alone { PERCENT($systematic, digits: 0) } %
target-quantity-unknown = { $name }: not determined
