estimation-mass = { $decimals ->
    [0] { FIXED($mass_kg, digits: 0) } kg (±{ FIXED($half_width_kg, digits: 0) } kg, 95 %)
    [1] { FIXED($mass_kg, digits: 1) } kg (±{ FIXED($half_width_kg, digits: 1) } kg, 95 %)
    [2] { FIXED($mass_kg, digits: 2) } kg (±{ FIXED($half_width_kg, digits: 2) } kg, 95 %)
    [3] { FIXED($mass_kg, digits: 3) } kg (±{ FIXED($half_width_kg, digits: 3) } kg, 95 %)
    [4] { FIXED($mass_kg, digits: 4) } kg (±{ FIXED($half_width_kg, digits: 4) } kg, 95 %)
    [5] { FIXED($mass_kg, digits: 5) } kg (±{ FIXED($half_width_kg, digits: 5) } kg, 95 %)
   *[other] { FIXED($mass_kg, digits: 6) } kg (±{ FIXED($half_width_kg, digits: 6) } kg, 95 %)
}
estimation-all-determined = Die Last hat { estimation-mass }; alle zehn Trägheitsparameter sind bestimmt.
estimation-inertia-not-determined = Die Last hat { estimation-mass }; Masse und erstes Moment sind bestimmt, die Trägheit ist es nicht (die Bewegung regt die Trägheit nicht genug an).
estimation-inertia-not-determined-standing = Die Last hat { estimation-mass }; Masse und erstes Moment sind bestimmt, die Trägheit ist es nicht ({ estimation-standing }).
estimation-partly-determined = Die Last hat { estimation-mass }; nicht bestimmt: { $missing }.
estimation-nothing-determined = Die Last ist nicht bestimmt: { $reason }.
estimation-standing = nur einzelne Stellungen: die Trägheit ist nicht angeregt
estimation-no-rotation = keine Drehung um { $axis }
estimation-no-rotation-of-two = keine Drehung um { $axis } oder { $other }
estimation-two-reasons = { $rotation }; { $reason }
estimation-mass-uncertain = zu wenige verschiedene Stellungen, um das Gewicht vom Nullpunkt des Sensors zu trennen; die Standardunsicherheit wäre { SIGNIFICANT($std_kg, digits: 2) } kg gegen { SIGNIFICANT($scale_kg, digits: 2) } kg, die Größe, auf die es ankommt
estimation-first-moment-uncertain = Schwerkraft aus zu wenigen Richtungen, um das erste Moment um { $axis } vom Nullpunkt zu trennen; die Standardunsicherheit wäre { SIGNIFICANT($std_kg_m, digits: 2) } kg m gegen { SIGNIFICANT($scale_kg_m, digits: 2) } kg m, die Größe, auf die es ankommt
estimation-inertia-uncertain = zu wenig Winkelbeschleunigung; { estimation-inertia-size }
estimation-inertia-uncertain-about = kaum Winkelbeschleunigung um { $axes }; { estimation-inertia-size }
estimation-inertia-size = die Standardunsicherheit wäre { SIGNIFICANT($std_kg_m2, digits: 2) } kg m² gegen { SIGNIFICANT($scale_kg_m2, digits: 2) } kg m², die Größe, auf die es ankommt
estimation-too-few-still = zu wenige Messwerte im Stillstand, und keine Bewegung, die an ihre Stelle treten könnte
estimation-rows-at-rest = eine Zeile in { MILLI($period_s, digits: 0) } ms ist zu langsam, um zu sagen, wie es sich dazwischen bewegt hat: nur die ruhenden, { $used } von { $rows } Zeilen, wurden verwendet; wer schneller aufzeichnet, sieht die Trägheit
estimation-turned-about = Positionen fehlen: angenommen ist, dass der Sensor um eine ruhende Stelle gedreht wurde, { FIXED($distance_m, digits: 2) } m (Standardunsicherheit { FIXED($std_m, digits: 2) } m) von seinem Ursprung; genauer wird es mit aufgezeichneten Positionen oder mit mehreren ruhenden Stellungen
estimation-place-uncertain = Positionen fehlen, und die Stelle, um die der Sensor gedreht wurde, ist nicht genau genug bekannt
estimation-too-short = { FIXED($lasts_s, digits: 2) } s sind zu kurz, um etwas zu sagen
estimation-no-motion = die Aufzeichnung enthält neben den Kräften weder Gelenke noch Stellungen
estimation-motion-broken = es fehlen so viele Zeilen hintereinander oder wiederholen sich, dass sich über die Bewegung nichts sagen lässt: Masse und erstes Moment stammen aus den Haltephasen
estimation-residual-above-noise = der Rest ist größer als das Rauschen des Sensors, am meisten in { $channel } ({ FIXED($times, digits: 1) }-mal): etwas, das im Modell fehlt; die Unsicherheiten wurden vergrößert, aber ein Fehler, der sich wiederholt, ist kein Rauschen
estimation-not-converged = die Schätzung kam nicht zur Ruhe: die Bewegung trennt nicht, was zu bestimmen ist; auf die Zahlen ist kein Verlass
estimation-no-such-body = für sich allein verlangten die Daten einen Körper, den es nicht geben kann; genommen wurde der nächste, den es geben kann
estimation-noise-of-residual = kein Stillstand war lang genug, um das Rauschen des Sensors zu messen: es wurde dem Rest entnommen
estimation-saturated = der Sensor stand am Ende seines Bereichs: { $channels }
estimation-base-tilt = die Basis steht schief: { DEGREES($angle_rad, digits: 2) } Grad; berücksichtigt
estimation-wrench-late = die Kraftmessung kommt gegen die Gelenke { MILLI($late_s, digits: 1) } ms (±{ MILLI($half_width_s, digits: 2) } ms, 95 %) zu spät; berücksichtigt
estimation-wrench-early = die Kraftmessung kommt gegen die Gelenke { MILLI($early_s, digits: 1) } ms (±{ MILLI($half_width_s, digits: 2) } ms, 95 %) zu früh; berücksichtigt
estimation-gears-accounted = der Arm schwingt auf seinen Getrieben, wie gesunde Arme es tun (weichstes Gelenk { FIXED($softest_nm_per_rad, digits: 0) } N m/rad); berücksichtigt
estimation-drift-accounted = { $drift }; berücksichtigt
estimation-drift = der Nullpunkt des Sensors wanderte: { $channels }
estimation-no-drift = der Nullpunkt des Sensors wanderte nicht über sein Rauschen hinaus
estimation-drift-of-force = { $channel } { SIGNIFICANT($range_n, digits: 2) } N
estimation-drift-of-torque = { $channel } { SIGNIFICANT($range_n_m, digits: 2) } N m
estimation-transfers-alone = nicht gedreht wurde um { $axes }: { $parameters } beruhen allein auf den Fahrten, und keine ausgelassene Drehung prüft sie nach
estimation-effect-left-out = ein Effekt des Zwillings konnte nicht berücksichtigt werden, { $reason }
estimation-source-repeatability = Wiederholbarkeit
estimation-source-sensor-gain = Sensorkennwert
estimation-source-sensor-crosstalk = Übersprechen
estimation-source-joint-zeros = Gelenknullpunkte
estimation-source-sensor-mount = Sensoranbau
estimation-source-gravity = Fallbeschleunigung
estimation-source-twin = Zwilling
estimation-assumed-gain = die Kalibrierung des Sensors ist nicht angegeben: angenommen ist 1 % der Last als Unsicherheit des Kennwerts (Werte des Kalibrierscheins unter sensor.calibration eintragen)
estimation-assumed-crosstalk = das Übersprechen des Sensors ist nicht angegeben: angenommen sind 0,5 % des Messbereichs bei voller Last (Werte des Kalibrierscheins unter sensor.calibration eintragen)
estimation-assumed-gravity = der Standort der Zelle ist nicht angegeben: für die örtliche Fallbeschleunigung sind 0,015 m/s² Unsicherheit angenommen (Breite und Höhe unter site eintragen)
estimation-assumed-zeros = die Unsicherheit der Gelenknullpunkte ist nicht angegeben: angenommen sind 0,05° (zero_std_rad unter robot eintragen)
estimation-assumed-mount = die Unsicherheit des Sensoranbaus ist nicht angegeben: angenommen sind 0,1° (mount_std_rad unter sensor eintragen)
estimation-no-reference =
    .found = keine Referenz in einem der Läufe
    .expected = Läufe, die eine nennen (payload_reference), oder kein Vorwissen
estimation-different-references =
    .found = Referenzen, die sich von Lauf zu Lauf unterscheiden
    .expected = eine Last mit einer Referenz
