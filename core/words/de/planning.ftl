planning-rejected = { $reason } { $count }
planning-no-start-configuration =
    keine Startstellung mit Sensorachse { $axis } entlang der Schwerkraft: verworfen: { $kinds ->
        [0] nichts, kein Kandidat
       *[other] { $rejected }
    }. Räumen Sie weg, was im Weg ist, verkleinern Sie den Hüllquader der Last, limits.clearance_m oder limits.self_clearance_m, oder suchen Sie länger (--effort), und planen Sie neu.
planning-no-start-configuration-near =
    keine Startstellung mit Sensorachse { $axis } entlang der Schwerkraft: verworfen: { $kinds ->
        [0] nichts, kein Kandidat
       *[other] { $rejected }
    }; der größte erreichte Abstand war { FIXED($best_clearance_m, digits: 3) } m zu „{ $nearest }“. Räumen Sie weg, was im Weg ist, verkleinern Sie den Hüllquader der Last, limits.clearance_m oder limits.self_clearance_m, oder suchen Sie länger (--effort), und planen Sie neu.
planning-other-axes = { $refusal } Für die übrigen Sensorachsen gibt es einen Plan: --axes { $axes }.
