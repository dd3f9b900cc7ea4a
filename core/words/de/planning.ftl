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
    }; der größte erreichte Abstand war { FIXED($best_clearance_m, digits: 3) } m zu { $nearest }. Räumen Sie weg, was im Weg ist, verkleinern Sie den Hüllquader der Last, limits.clearance_m oder limits.self_clearance_m, oder suchen Sie länger (--effort), und planen Sie neu.
planning-other-axes = { $refusal } Für die übrigen Sensorachsen gibt es einen Plan: --axes { $axes }.

# Was eine Stellung als Startstellung ausscheiden lässt.
planning-rejected-unreachable = unerreichbar
planning-rejected-obstacle = zu nah an { $body }
planning-rejected-bodies = { $first } zu nah an { $second }
planning-rejected-throw = eine Last, die sich löst, flöge in die Zone „{ $zone }“
planning-rejected-joint-too-weak = Gelenk „{ $joint }“ zu schwach, um die Last zu halten
planning-rejected-rotation-bodies = kein Platz für die Drehung: { $first } zu nah an { $second }
planning-rejected-joint-limits = Gelenkgrenzen während der Drehung
planning-rejected-joint-speed = Gelenkgeschwindigkeit während der Drehung
planning-rejected-joint-acceleration = Gelenkbeschleunigung während der Drehung
planning-rejected-cartesian-speed = Geschwindigkeit im Raum während der Drehung

# Die Enden eines Weges.
planning-end-start = Anfang
planning-end-goal = Ende
planning-end-no-configuration = { $end } des Weges: { $q_rad }; erwartet: { $count } endliche Gelenkstellungen in rad.
planning-end-outside-limits = { $end } des Weges: { $joint } bei { FIXED($angle_rad, digits: 3) } rad, außerhalb seiner Grenzen [{ FIXED($lower_rad, digits: 3) }; { FIXED($upper_rad, digits: 3) }] rad. Wählen Sie eine andere Stellung.
planning-end-inside = { $end } des Weges: { $first } ragt { FIXED($depth_m) } m in { $second } hinein. Wählen Sie eine andere Stellung, verkleinern Sie den Hüllquader der Last oder räumen Sie die Zelle.
planning-end-too-close = { $end } des Weges: { $first } ist { FIXED($distance_m, digits: 4) } m von { $second } entfernt (Grenze { FIXED($required_m, digits: 3) } m). Wählen Sie eine andere Stellung oder räumen Sie die Zelle.
planning-end-drops-load = { $end } des Weges: eine Last, die sich löst, fiele { FIXED($depth_m, digits: 4) } m in die Zone „{ $zone }“. Wählen Sie eine andere Stellung, verkleinern Sie den Hüllquader, oder verschieben Sie die Zone.

# Kein Weg, oder keiner, der befohlen werden darf.
planning-no-path = kein Weg gefunden in { $iterations } Durchgängen mit { $planner }: die Suche kam bis auf { FIXED($left_rad, digits: 2) } rad an das Ziel, das { FIXED($whole_rad, digits: 2) } rad entfernt ist; am engeren Ende ist { $first } { FIXED($distance_m, digits: 3) } m von { $second } entfernt (Grenze { FIXED($required_m, digits: 3) } m). Suchen Sie mehr (--effort), wählen Sie eine andere Startstellung oder räumen Sie die Zelle.
planning-corner-too-tight = eine Ecke des Weges bei ({ $corner_rad }) rad lässt sich nicht um { FIXED($smallest_rad, digits: 4) } rad runden, ohne den Abstand zu unterschreiten. Planen Sie neu mit einem anderen Startwert, oder geben Sie dem Weg mehr Platz.
planning-rounding-too-close = der Weg kommt { FIXED($depth_m, digits: 4) } m zu nahe ({ $first } an { $second }), wo seine Ecken gerundet sind. Planen Sie neu mit einem anderen Startwert, oder geben Sie ihm mehr Platz.
planning-no-timing = keine Zeitplanung des Weges hält die Grenzen ein: { FIXED($excess, digits: 3) }-fache Grenze nach { $rounds } Durchgängen. Planen Sie neu.
planning-transfer-throws-load = eine Last, die sich { FIXED($time_s, digits: 3) } s nach dem Beginn des Weges bei { FIXED($speed_m_s, digits: 3) } m/s löst, flöge { FIXED($depth_m, digits: 4) } m in die Zone „{ $zone }“. Planen Sie neu mit einem anderen Startwert, verkleinern Sie den Hüllquader, oder verschieben Sie die Zone.
planning-stands-inside = wo der Roboter steht, ragt { $first } { FIXED($depth_m) } m in { $second } hinein. Verkleinern Sie den Hüllquader der Last oder räumen Sie die Zelle.
planning-stands-too-close = der Roboter steht mit { $first } { FIXED($distance_m, digits: 4) } m von { $second } entfernt (Grenze { FIXED($required_m, digits: 3) } m). Räumen Sie die Zelle.
planning-no-room-for-wave = kein Platz für eine breitbandige Bewegung: schon Ausschläge von { MILLI($swing_rad, digits: 1) } mrad verlassen die Grenzen, kommen etwas zu nahe oder könnten eine Last in eine Zone werfen. Wählen Sie eine andere Bewegung, oder geben Sie dem Roboter mehr Platz.

# Gelenkmomente mit der Last.
planning-load-known = Last „{ $payload }“, wie die Zelle sie kennt
planning-load-guessed = eine geschätzte Masse, gleichmäßig über den Hüllquader der Last verteilt
planning-load-payload-limit = die Traglast des Roboters, gleichmäßig über den Hüllquader der Last verteilt
planning-joint-without-effort = „{ $joint }“: in der URDF steht kein effort
planning-joint-without-mass = „{ $joint }“: in der URDF steht keine Masse des Glieds nach „{ $after }“
planning-too-heavy = die Last von { FIXED($mass_kg, digits: 3) } kg ist zu schwer für „{ $joint }“: gebraucht würden { FIXED($torque_n_m, digits: 1) } N m (Grenze { FIXED($limit_n_m, digits: 1) } N m), davon { FIXED($holding_n_m, digits: 1) } N m, um stillzuhalten, { FIXED($time_s, digits: 3) } s nach dem Beginn von: { $part }. Nehmen Sie eine leichtere Last oder eine andere Heimstellung, oder berichtigen Sie effort in der URDF.
planning-too-heavy-to-hold = keine Startstellung mit der Sensorachse { $axis } längs der Schwerkraft: die Last ist zu schwer; um sie stillzuhalten, bräuchte „{ $joint }“ mindestens { PERCENT($share) } % seines Drehmoments (Grenze { PERCENT($most_share) } %). Nehmen Sie eine leichtere Last, geben Sie dem Roboter mehr Platz, oder berichtigen Sie effort in der URDF.

# Teile eines Plans, und was ein zweiter Blick auf ihn findet.
planning-part-transfer = Fahrt nach { $axis }
planning-part-rotation = Drehung um { $axis }
planning-part-wave = Schwingung bei { $axis }
planning-part-home = Heimfahrt
planning-part-start = Anfang
planning-not-feasible = der fertige Plan lässt sich nicht ausführen: { $part }. Planen Sie neu mit einem anderen Startwert.
planning-disputed-distance = ein zweiter Blick auf den fertigen Plan findet { $first } { FIXED($distance_m, digits: 4) } m von { $second } entfernt (Grenze { FIXED($required_m, digits: 3) } m), { FIXED($time_s, digits: 3) } s nach dem Beginn von: { $part }. Planen Sie neu mit einem anderen Startwert, oder geben Sie dem Roboter mehr Platz.
planning-disputed-throw = ein zweiter Blick auf den fertigen Plan findet, dass eine Last, die sich bei { FIXED($speed_m_s, digits: 3) } m/s löst, { FIXED($time_s, digits: 3) } s nach dem Beginn von: { $part }, { FIXED($depth_m, digits: 4) } m in die Zone „{ $zone }“ flöge. Planen Sie neu mit einem anderen Startwert, oder geben Sie dem Roboter mehr Platz.
planning-disputed-speed = ein zweiter Blick auf den fertigen Plan findet eine Ecke von { $body } bei { FIXED($speed_m_s, digits: 4) } m/s (Grenze { FIXED($limit_m_s, digits: 3) } m/s), { FIXED($time_s, digits: 3) } s nach dem Beginn von: { $part }. Planen Sie neu mit einem anderen Startwert.

# Mängel dessen, womit ein Plan verlangt wurde.
planning-axes-unknown =
    .found = „{ $axes }“
    .expected = einige von x, y und z, durch Kommas getrennt
planning-torques-whole =
    .found = joint-torques neben { $option }
    .expected = eines von beiden: Bewegungen für die Drehmomente der Gelenke drehen um keine Sensorachse und werden ganz ausgeführt
planning-speed-out-of-range =
    .found = { SIGNIFICANT($speed_m_s, digits: 6) } m/s
    .expected = { SIGNIFICANT($slowest_m_s, digits: 6) } bis { SIGNIFICANT($limit_m_s, digits: 6) } m/s, die Grenze der Zelle
planning-start-wanted = Gelenkstellungen wie „0.1,-1.2,...“, der Ordner einer Aufzeichnung, oder eine JSON-Datei mit „q_rad“
planning-start-empty =
    .found = nichts
    .expected = { planning-start-wanted }
planning-start-unreadable =
    .found = „{ $text }“
    .expected = { planning-start-wanted }
planning-start-no-json =
    .found = kein JSON
    .expected = { planning-start-wanted }
planning-start-joints =
    .found = { $q_rad }
    .expected = { $count } endliche Gelenkstellungen in rad, für { $joints }
planning-start-recording-without-joints =
    .found = eine Aufzeichnung ohne Gelenkstellungen
    .expected = eine mit q oder q_cmd
planning-start-file-too-long =
    .found = eine zu lange Datei
    .expected = höchstens { $most_bytes } Bytes
planning-period-no-multiple =
    .found = { SIGNIFICANT($period_s, digits: 6) } s
    .expected = ein Vielfaches von { SIGNIFICANT($own_s, digits: 6) } s, der Periode des Plans, bis { SIGNIFICANT($most_s, digits: 6) } s
planning-period-without-file =
    .found = { SIGNIFICANT($period_s, digits: 6) } s ohne --trajectory
    .expected = --trajectory FILE, wofür sie ist
planning-trajectory-file-ending =
    .found = { $file }
    .expected = eine Datei, die mit .csv oder .json endet
planning-trajectory-folder-missing =
    .found = { $file }, in einem Ordner, den es nicht gibt
    .expected = eine Datei in einem Ordner, den es gibt
