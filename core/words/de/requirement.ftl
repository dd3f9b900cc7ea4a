# What the path of a program cannot be
requirement-unreadable =
    .found = nichts Lesbares ({ $reason })
    .expected = eine CSV-Datei mit Kopfzeile, der Zeit in s und den Gelenkstellungen in rad
requirement-no-numbers =
    .found = etwas anderes
    .expected = { $columns } Zahlen: die Zeit in s, dann die Stellung jedes Gelenks in rad
requirement-no-rows =
    .found = weniger als zwei Zeilen
    .expected = eine Kopfzeile und Zeilen mit { $columns } Zahlen: die Zeit in s, dann die Stellung jedes Gelenks in rad
requirement-time-stands =
    .found = { FIXED($time_s, digits: 3) } s nach { FIXED($before_s, digits: 3) } s
    .expected = steigende Zeiten
requirement-too-long =
    .found = eine Bahn von { FIXED($duration_s, digits: 0) } s
    .expected = höchstens { FIXED($limit_s, digits: 0) } s; die erste Spalte ist die Zeit in Sekunden
requirement-beyond-limits =
    .found = Gelenk { $joint } bei { FIXED($value_rad, digits: 3) } rad
    .expected = { FIXED($lower_rad, digits: 3) } bis { FIXED($upper_rad, digits: 3) } rad; Winkel in Radiant
requirement-no-payload =
    .found = ein Ergebnis ohne alle zehn Parameter
    .expected = eines, das sagt, was der Roboter trägt

# What may be off, and what then happens
requirement-mass = Masse
requirement-centre-of-mass = Schwerpunkt
requirement-inertia = Trägheit
requirement-criterion-joint-torque = Gelenk { $joint } { FIXED($threshold_nm, digits: 1) } N m sieht, die niemand ausübt
requirement-criterion-tcp-force = im Sensorrahmen { FIXED($threshold_n, digits: 1) } N gesehen werden, die niemand ausübt
requirement-criterion-guiding-force = der Arm beim Führen von Hand mit { FIXED($threshold_n, digits: 1) } N drückt
requirement-criterion-mass = die { FIXED($threshold_kg, digits: 3) } kg erreicht sind, die der Hersteller zulässt
requirement-criterion-centre-of-mass = die { MILLI($threshold_m, digits: 1) } mm erreicht sind, die der Hersteller zulässt
requirement-motion-brisk = Über { FIXED($motion_s, digits: 0) } s Bewegungen zwischen zufälligen Stellungen, jede so schnell, wie die Grenzen der Zelle zulassen.
requirement-motion-program = Über die { FIXED($motion_s, digits: 0) } s Bewegung des Programms.
requirement-assumed = Die Zelle nennt keine Kontaktschwelle ([thresholds] in cell.toml): 20 N im Sensorrahmen werden angenommen.

# Whether an answer is good enough
requirement-no-answer = Kein Ergebnis zu beurteilen: --result nennt eines.
requirement-not-determined = Ob es genau genug ist, lässt sich nicht beurteilen: { $names } nicht bestimmt.
requirement-no-body = Ob es genau genug ist, lässt sich nicht beurteilen: Es wurde keine Last identifiziert.
requirement-good-enough = Genau genug für diese Zelle: { SIGNIFICANT($margin, digits: 7) }-mal genauer als nötig; entscheidend: { $decides }.
requirement-not-good-enough = Nicht genau genug für diese Zelle: { $name } – zulässiger Fehler { $error }, Intervall ± { $half_width }.
requirement-together-not-good-enough = Nicht genau genug für diese Zelle: Alle Unsicherheiten zusammen brauchen { PERCENT($used, digits: 0) } % dessen auf, was zulässig ist; entscheidend: { $decides }.
requirement-title = Genau genug wofür
requirement-used = Mit 95 % Wahrscheinlichkeit bleibt der Fehler unter { PERCENT($used, digits: 1) } % dessen, was es braucht, bis { $criterion }.
requirement-allowed = { $group }: zulässiger Fehler { $error }, bis { $criterion }.
requirement-allowed-any = { $group }: nichts begrenzt den Fehler.
requirement-source = Schwellen: { $source }.
requirement-parameter-com = Schwerpunkt entlang { $axis }
requirement-parameter-moment = Trägheit um { $axis }
requirement-parameter-product = Deviationsmoment { $axes }
requirement-kg = { SIGNIFICANT($value_kg, digits: 7) } kg
requirement-mm = { SIGNIFICANT($value_mm, digits: 7) } mm
requirement-kg-m2 = { SIGNIFICANT($value_kg_m2, digits: 7) } kg m²
