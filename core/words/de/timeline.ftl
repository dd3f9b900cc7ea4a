# Several recordings of one cell: which effect came when. An effect is called as in effect.ftl.
timeline-came = Aufgetreten zwischen { $first } und { $then }: { $effect }.
timeline-went = Verschwunden zwischen { $first } und { $then }: { $effect }.
timeline-before = Schon in { $first } vorhanden: { $effect }.
timeline-nothing = Kein Effekt ist aufgetreten oder verschwunden.

# Why they cannot be held against each other.
timeline-other-robot =
    .found = ein anderer Roboter als in { $first }
    .expected = Aufzeichnungen einer einzigen Zelle
timeline-other-twin =
    .found = eine Diagnose, die mit einem anderen Zwilling begann als die von { $first }
    .expected = Diagnosen, die mit demselben begannen: die Aufzeichnungen gemeinsam diagnostizieren
