# What in a twin.json cannot be used.
twin-not-written =
    .found = a folder that cannot be written ({ $reason })
    .expected = one that is yours to change
twin-unknown-effect =
    .found = '{ $effect }'
    .expected = { $meant }
twin-effect-twice =
    .found = '{ $effect }' { $count } times
    .expected = each effect once
twin-unknown-parameter =
    .found = no parameter of { $effect }
    .expected = { $meant }
twin-no-such-key =
    .found = no such key
    .expected = it
twin-unit =
    .found = '{ $unit }'
    .expected = '{ $right }'
twin-out-of-bounds =
    .found = { SIGNIFICANT($figure, digits: 6) } { $unit }
    .expected = between { SIGNIFICANT($lower, digits: 6) } and { SIGNIFICANT($upper, digits: 6) }
twin-covariance-size =
    .found = { $rows } rows
    .expected = { $count } by { $count } numbers
twin-no-covariance =
    .found = a matrix that is not symmetric and positive
    .expected = a covariance
twin-changed =
    .found = a change of { $effects } since the diagnosis
    .expected = the twin that it counted with, but for what is added; diagnose the recording again

# What an unknown name is answered with.
twin-close-name = '{ $name }', if that is what was meant
twin-known-names = one of { $names }

# An effect of the twin that cannot be evaluated in a recording.
twin-lacking = { $effect }: { $reason }
