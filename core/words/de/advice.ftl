# What a person should do about an effect, with its figures.
advice-base-tilt = Richten Sie die Basis waagrecht aus: drehen Sie sie um { DEGREES($first_rad, digits: 2) }° um { $first_axis } und um { DEGREES($second_rad, digits: 2) }° um { $second_axis } des Basiskoordinatensystems; oder drehen Sie die Richtung der Schwerkraft in der Zelle um dieselben Winkel.
advice-base-tilt-leans = Befestigen Sie die Basis oder stellen Sie sie auf steife Füße: sie neigt sich um bis zu { DEGREES($lean_rad, digits: 2) }°, wenn sich der Arm bewegt. Richten Sie sie dann aus.
advice-base-tilt-sinks = Stellen Sie die Basis auf festen Grund und befestigen Sie sie: ab { FIXED($at_s, digits: 1) } s sank sie um { DEGREES($sunk_rad, digits: 2) }° ein. Richten Sie sie dann aus.
advice-cable-drag = Legen Sie Schlauch oder Kabel frei: anfangs ist der Zug { FIXED($pull_n, digits: 1) } N, er ändert sich um { FIXED($stiffness_n_per_m, digits: 1) } N je Meter, und die Reibung ist { FIXED($friction_n, digits: 1) } N.
advice-cable-drag-twisting = Legen Sie Schlauch oder Kabel frei: anfangs ist der Zug { FIXED($pull_n, digits: 1) } N, er ändert sich um { FIXED($stiffness_n_per_m, digits: 1) } N je Meter, die Reibung ist { FIXED($friction_n, digits: 1) } N, und die Verdrehung wirkt mit { FIXED($twist_nm_per_rad, digits: 2) } N m je rad.
advice-external-contact = Halten Sie die Last frei: von { FIXED($begin_s, digits: 1) } bis { FIXED($end_s, digits: 1) } s drückte etwas mit bis zu { FIXED($force_n, digits: 1) } N gegen sie; lassen Sie diesen Teil weg, oder fahren Sie erneut.
advice-gear-ripple = Drehen Sie Gelenk { $joint } beim Messen mit einer anderen Geschwindigkeit: sein Getriebe weicht { FIXED($per_turn, digits: 0) }-mal je Umdrehung um { DEGREES($amplitude_rad, digits: 4) }° ab.
advice-joint-backlash = Lassen Sie das Getriebe von Gelenk { $joint } einstellen: es hat von Seite zu Seite { DEGREES($play_rad, digits: 3) }° Spiel.
advice-joint-elasticity = Nehmen Sie die Steifigkeit der Gelenke in den Zwilling der Zelle auf (Gelenk { $joint }: { FIXED($stiffness_nm_per_rad, digits: 0) } N m/rad, es gibt um bis zu { DEGREES($give_rad, digits: 2) }° nach), oder verwenden Sie Geber auf der Abtriebsseite.
advice-joint-elasticity-rigid = Nehmen Sie die Steifigkeit der Gelenke in den Zwilling der Zelle auf, oder verwenden Sie Geber auf der Abtriebsseite.
advice-joint-friction = Fahren Sie die Gelenke einige Minuten warm, lassen Sie nachsehen, welche mehr reiben als früher, und geben Sie die bleibende Reibung in cell.toml an (robot.friction).
advice-joint-offset = Justieren Sie den Nullpunkt von Gelenk { $joint }, der um { DEGREES($error_rad, digits: 2) }° verschoben ist (alle Gelenke: { $zeros }).
advice-joint-offset-uneven = Zentrieren oder ersetzen Sie den Geber von Gelenk { $joint }, der einmal je Umdrehung um { DEGREES($error_rad, digits: 2) }° abweicht.
advice-joint-offset-warming = Lassen Sie den Arm vor dem Messen einige Minuten laufen: der Nullpunkt von Gelenk { $joint } wandert um { DEGREES($change_rad, digits: 2) }° in { FIXED($within_s, digits: 0) } s.
advice-kinematic-lag = Zeichnen Sie ungefilterte Gelenkstellungen auf, oder verschieben Sie die Zeitstempel der Gelenke um { MILLI($lag_s, digits: 1) } ms nach vorn.
advice-kinematic-lag-joints = Zeichnen Sie die Stellungen aller Gelenke zum selben Zeitpunkt und ungefiltert auf: Gelenk { $joint } ist { MILLI($lag_s, digits: 1) } ms zu spät, das mit der kleinsten Verspätung { MILLI($least_s, digits: 1) } ms.
advice-kinematic-lag-opens = Zeichnen Sie ungefilterte Gelenkstellungen auf: Ihr Filter öffnet sich mit der Geschwindigkeit, in Ruhe sind sie { MILLI($lag_s, digits: 1) } ms zu spät, bei { SIGNIFICANT($speed_rad_s, digits: 2) } rad/s die Hälfte davon.
advice-payload-loose = Befestigen Sie das lose Teil der Last: etwa { PERCENT($mass_share) } % ihrer Masse geben unter ihrem Gewicht um { MILLI($sag_m) } mm nach und schwingen mit { FIXED($frequency_hz, digits: 1) } Hz.
advice-payload-loose-fluid = Füllen oder leeren Sie, worin in der Last etwas fließt: es läuft in { FIXED($settling_s, digits: 1) } s zur tiefen Seite und ändert das statische Moment um { MILLI($first_moment_kg_m, digits: 1) } kg mm nach jeder Seite.
advice-payload-loose-hanging = Befestigen Sie das lose Teil der Last: etwa { PERCENT($mass_share) } % ihrer Masse hängen { MILLI($sag_m) } mm unter der Aufhängung und schwingen mit { FIXED($frequency_hz, digits: 1) } Hz.
advice-payload-loose-hinge = Befestigen Sie das drehbare Teil der Last: seine schwere Seite sinkt nach unten. Sein statisches Moment um die Drehachse beträgt { MILLI($first_moment_kg_m, digits: 1) } kg mm.
advice-payload-loose-stops = Befestigen Sie das lose Teil der Last: es rutscht von Anschlag zu Anschlag und ändert das statische Moment um { MILLI($first_moment_kg_m, digits: 1) } kg mm nach jeder Seite.
advice-payload-loose-vessel = Befestigen Sie, was in der Last schwingt, oder füllen Sie den Behälter: etwa { PERCENT($mass_share) } % der Masse schwingen mit { FIXED($frequency_hz, digits: 1) } Hz, bis eine Wand sie { DEGREES($wall_rad, digits: 0) }° neben der Mitte anhält.
advice-payload-mass-gained = Prüfen Sie die Last: bei { FIXED($at_s, digits: 1) } s gewann sie { MILLI($mass_kg) } g bei ({ MILLI($x_m) }; { MILLI($y_m) }; { MILLI($z_m) }) mm vom Sensor; identifizieren Sie sie danach erneut.
advice-payload-mass-lost = Prüfen Sie die Last: bei { FIXED($at_s, digits: 1) } s verlor sie { MILLI($mass_kg) } g bei ({ MILLI($x_m) }; { MILLI($y_m) }; { MILLI($z_m) }) mm vom Sensor; identifizieren Sie sie danach erneut.
advice-payload-mismatch = Prüfen Sie, ob die richtige Last montiert ist, und ersetzen Sie die Referenz durch die gefundenen Werte.
advice-payload-mismatch-heavier = Prüfen Sie, ob die richtige Last montiert ist, und ersetzen Sie die Referenz durch die gefundenen Werte (sie ist { MILLI($mass_kg) } g schwerer).
advice-payload-mismatch-lighter = Prüfen Sie, ob die richtige Last montiert ist, und ersetzen Sie die Referenz durch die gefundenen Werte (sie ist { MILLI($mass_kg) } g leichter).
advice-payload-shift = Spannen Sie die Last fester: bei { FIXED($at_s, digits: 1) } s verrutschte sie um { MILLI($first_moment_kg_m, digits: 1) } kg mm; identifizieren Sie sie danach erneut.
advice-payload-shift-of-whole = Spannen Sie die Last fester: bei { FIXED($at_s, digits: 1) } s verrutschte sie um { MILLI($first_moment_kg_m, digits: 1) } kg mm (die ganze Last um { MILLI($distance_m, digits: 1) } mm); identifizieren Sie sie danach erneut.
advice-payload-shift-several = Spannen Sie die Last fester: von { FIXED($first_s, digits: 1) } bis { FIXED($last_s, digits: 1) } s verrutschte sie mehrmals, um bis zu { MILLI($first_moment_kg_m, digits: 1) } kg mm; identifizieren Sie sie danach erneut.
advice-sample-dropout = Gleichen Sie die Rate der Aufzeichnung der des Sensors an, oder entlasten Sie seinen Bus: { $held_share ->
    [0] { PERCENT($lost_share, digits: 1) } % der Messwerte gehen verloren.
   *[other] { $lost_share ->
        [0] { PERCENT($held_share, digits: 1) } % der Messwerte wiederholen sich.
       *[other] { PERCENT($held_share, digits: 1) } % der Messwerte wiederholen sich, und { PERCENT($lost_share, digits: 1) } % gehen verloren.
    }
}
advice-sensor-creep = Warten Sie nach einer Laständerung etwa { FIXED($wait_s, digits: 0) } s, bevor Sie nullen oder messen: { $channel } kriecht in { FIXED($within_s, digits: 0) } s um { PERCENT($creep_share, digits: 2) } % der Änderung.
advice-sensor-crosstalk = Laden Sie die Kalibriermatrix des Sensors neu, oder lassen Sie ihn neu kalibrieren: { $load } von { $of_channel } erscheint als { $shown } in { $in_channel }.
advice-sensor-crosstalk-products = Lassen Sie den Sensor mit Lasten in mehreren Kanälen zugleich kalibrieren: { $first } mal { $second } bringt { PERCENT($share, digits: 1) } % seiner Last in { $in_channel }.
advice-sensor-drift = Lassen Sie den Sensor 20 Minuten warm werden, und nullen Sie ihn kurz vor dem Lauf: sein Nullpunkt wanderte in { FIXED($within_s, digits: 0) } s um { $drift }.
advice-sensor-gain = Lassen Sie den Sensor mit bekannten Gewichten in beiden Richtungen neu kalibrieren: gegen die anderen Kanäle weicht { $channel } um { PERCENT($positive_share, digits: 1) } % ab, wo er positiv ist, und um { PERCENT($negative_share, digits: 1) } %, wo er negativ ist.
advice-sensor-gain-jump = Lassen Sie prüfen, ob sich im Sensor ein Dehnungsmessstreifen oder eine Ader gelöst hat, und ihn neu kalibrieren: { $channel } änderte seine Verstärkung bei { FIXED($at_s, digits: 1) } s um { PERCENT($change_share, digits: 1) } %.
advice-sensor-gain-swing = Sehen Sie nach der Versorgung des Sensors, die alle { FIXED($cycle_s, digits: 0) } s auf und ab geht (ein Ladegerät oder eine Heizung am selben Netz): die Verstärkung von { $channel } weicht im Mittel um { PERCENT($gain_share, digits: 1) } % ab und schwankt um { PERCENT($swing_share, digits: 1) } %.
advice-sensor-gain-warming = Lassen Sie den Sensor vor dem Lauf 20 Minuten warm werden, und lassen Sie ihn neu kalibrieren, wenn das nicht hilft: { $channel } änderte seine Verstärkung in { FIXED($within_s, digits: 0) } s um { PERCENT($change_share, digits: 1) } %.
advice-sensor-hysteresis = Prüfen Sie die Schrauben der Sensorflansche auf Schlupf; sonst fahren Sie jede Stellung von derselben Seite an: zwischen Be- und Entlasten weicht { $channel } um { PERCENT($height_share, digits: 2) } % des Messbereichs ab.
advice-sensor-interference = Führen Sie das Sensorkabel fern von Motor- und Netzkabeln, und erden Sie seinen Schirm an einem Ende, um die Linie bei { FIXED($frequency_hz, digits: 1) } Hz loszuwerden.
advice-sensor-lowpass = Schalten Sie den Filter des Sensors ab, oder setzen Sie seine Grenzfrequenz weit über { FIXED($cutoff_hz, digits: 0) } Hz; er verzögert um { MILLI($delay_s) } ms.
advice-sensor-noise = Prüfen Sie Versorgung, Schirm und Kabel des Sensors ({ $channel } rauscht { FIXED($times, digits: 1) }-mal so stark wie angegeben), oder geben Sie das höhere Rauschen an und halten Sie länger.
advice-sensor-nonlinearity = Lassen Sie die Linearität des Sensors mit bekannten Gewichten prüfen: bei Vollausschlag weicht { $channel } um { PERCENT($bend_share, digits: 1) } % von der Geraden ab.
advice-sensor-nonlinearity-knee = Suchen Sie nach Schmutz oder einer Abdeckung, die im Sensor ab { $load } anliegt, und lassen Sie seine Linearität mit bekannten Gewichten prüfen: von da an weicht die Steigung von { $channel } um { PERCENT($change_share, digits: 1) } % ab.
advice-sensor-nonlinearity-polynomial = Lassen Sie die Linearität des Sensors mit bekannten Gewichten auf Zug und Druck prüfen: bei { $load } weicht { $channel } um { PERCENT($bend_share, digits: 1) } % von der Geraden ab.
advice-sensor-offset-step = Prüfen Sie Stecker und Kabel des Sensors, und nullen Sie ihn: { FIXED($at_s, digits: 1) } s nach dem Anfang sprang sein Nullpunkt um { $step }.
advice-sensor-quantization = Wählen Sie die feinste Auflösung des Sensors oder einen kleineren Messbereich: { $channel } kommt in Stufen von { $step }; bewegen Sie bis dahin beim Halten ein wenig.
advice-sensor-rotation = Berichtigen Sie das Sensorkoordinatensystem in der URDF: drehen Sie es um { DEGREES($x_rad, digits: 2) }°, { DEGREES($y_rad, digits: 2) }° und { DEGREES($z_rad, digits: 2) }° um seine Achsen x, y und z, oder montieren Sie den Sensor neu.
advice-sensor-rotation-rocks = Ziehen Sie die Schrauben des Sensors an: er kippelt mit dem Drehmoment um bis zu { DEGREES($slip_rad, digits: 2) }° nach jeder Seite.
advice-sensor-saturation-above = Wählen Sie einen größeren Messbereich des Sensors oder eine leichtere Last: { $channel } wird über { $clipped_at } begrenzt (ohne Nullpunkt), der Lauf braucht { $needed }.
advice-sensor-saturation-below = Wählen Sie einen größeren Messbereich des Sensors oder eine leichtere Last: { $channel } wird unter { $clipped_at } begrenzt (ohne Nullpunkt), der Lauf braucht { $needed }.
advice-sensor-saturation-bridge = Wählen Sie einen größeren Messbereich des Sensors oder eine leichtere Last: seine Brücken sind in { PERCENT($share) } % des Laufs an ihrem Ende, am meisten fehlt dadurch in { $channel }.
advice-sensor-translation = Verschieben Sie das Sensorkoordinatensystem in der URDF um { MILLI($x_m, digits: 1) } mm, { MILLI($y_m, digits: 1) } mm und { MILLI($z_m, digits: 1) } mm längs seiner Achsen x, y und z.
advice-sensor-translation-split = Lassen Sie den Sensor kalibrieren: zwei seiner Momente gelten um Ursprünge, die { MILLI($apart_m, digits: 1) } mm auseinander auf { $axis } liegen.
advice-structure-vibration = Suchen Sie, was mit { FIXED($frequency_hz, digits: 1) } Hz schwingt (eine Maschine neben dem Roboter, ein Tisch, der nicht fest steht, ein Stoß), oder halten Sie länger und messen Sie, wenn es ruhig ist.
advice-time-delay = Stempeln Sie Kräfte und Gelenke mit einer Uhr, oder stellen Sie in der Aufzeichnung eine Verzögerung von { MILLI($delay_s, digits: 1) } ms ein.
advice-time-delay-grows = Stempeln Sie Kräfte und Gelenke mit einer Uhr, oder stellen Sie die Uhren nacheinander: Die Kräfte kommen mit jeder Minute { MILLI($per_minute_s, digits: 1) } ms später.
advice-time-delay-slips = Stempeln Sie Kräfte und Gelenke mit einer Uhr, ohne Puffer dazwischen: Die Verzögerung wächst um { MILLI($swing_s, digits: 1) } ms und fällt alle { FIXED($cycle_s, digits: 1) } s zurück.
advice-time-delay-wanders = Stempeln Sie Kräfte und Gelenke mit einer Uhr, und lassen Sie dazwischen nichts warten: Die Verzögerung schwankt zwischen { MILLI($least_s, digits: 1) } und { MILLI($most_s, digits: 1) } ms.
advice-tool-flexibility = Versteifen Sie das Werkzeug, oder glätten Sie die Bewegung: es schwingt mit { FIXED($frequency_hz, digits: 1) } Hz bei { PERCENT($damping_ratio) } % der kritischen Dämpfung.
advice-torque-offset = Setzen Sie die Momentensensoren der Gelenke neu auf null, wie es der Hersteller des Roboters beschreibt
advice-velocity-lag = Zeichnen Sie ungefilterte Gelenkgeschwindigkeiten auf, oder lassen Sie sie weg: diese folgen den Stellungen { MILLI($lag_s, digits: 1) } ms verspätet
