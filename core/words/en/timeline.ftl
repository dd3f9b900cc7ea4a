# Several recordings of one cell: which effect came when. An effect is called as in effect.ftl.
timeline-came = Came between { $first } and { $then }: { $effect }.
timeline-went = Went between { $first } and { $then }: { $effect }.
timeline-before = There already in { $first }: { $effect }.
timeline-nothing = No effect came or went.

# Why they cannot be held against each other.
timeline-other-robot =
    .found = another robot than in { $first }
    .expected = recordings of one cell
timeline-other-twin =
    .found = a diagnosis that began with another twin than that of { $first }
    .expected = diagnoses that began with the same one: diagnose the recordings together
