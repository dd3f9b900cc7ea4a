# Beide
report-and = und
report-or = oder
report-unit = Einheit
report-reference = Referenz
report-error = Fehler
report-limit = Grenze
report-interval = ± (95 %)
report-frame = Im Sensorkoordinatensystem, Trägheit um dessen Ursprung.
report-not-determined = nicht bestimmt

# Eine Bewegung, wie Aufzeichnungen und Pläne sie nennen
report-phase-hold = Halt { $axis }
report-phase-rotation = Drehung { $axis }
report-phase-transfer = Fahrt { $axis }
report-part-hold = Halt { $axis }
report-part-rotation = Drehung { $axis }
report-part-transfer = Fahrt nach { $axis }
report-part-wave = Schwenk { $axis }
report-part-between = Fahrt
report-part-home = Fahrt in die Grundstellung

# Kopf und Fuß
report-title = Last { $payload }
report-title-unnamed = Last
report-from-recording = aus einer Aufzeichnung
report-made-by = Erstellt von Heft { $version }. Heft ist keine Sicherheitsfunktion (safety_rated: false). Abstände und Geschwindigkeiten berechnet ein Programm, das niemand zertifiziert hat, aus den Gelenkstellungen; Menschen schützen die Sicherheitsfunktionen des Roboters und der Zelle, niemals dieser Bericht oder das Programm dahinter.

# Das Wichtigste
report-mass = Masse
report-com = Schwerpunkt
report-com-note = im Sensorkoordinatensystem; ± { $half_widths } mm (95 %)
report-moments = Hauptträgheitsmomente
report-moments-note = g m², um den Schwerpunkt
report-moments-impossible = g m², um den Schwerpunkt; kein starrer Körper hat diese Größen
report-base-tilt = Schiefstellung der Basis
report-base-tilt-note = um x und y der Basis, gegen die nominelle Schwerkraft; ± { $half_widths }
report-delay = Verzögerung der Kraftmessung
report-delay-note = gegen die Gelenke; ± { $half_width } ms (95 %)
report-accounted = Berücksichtigte Effekte
report-accounted-note = wie der Zwilling der Zelle sie hat; sie ändern die Masse um { MILLI($mass_kg, digits: 1) } g
report-smallest-distance = Kleinster Abstand
report-nearest = zu „{ $name }“; Grenze { FIXED($limit_m, digits: 3) } m
report-nearest-beyond-first = zu „{ $name }“; Grenze { FIXED($limit_m, digits: 3) } m; { FIXED($beyond_m, digits: 3) } m ohne die Glieder, die nur das erste Gelenk bewegt
report-largest-speed = Größte Geschwindigkeit
report-largest-speed-note = irgendeines Punkts; Grenze { FIXED($limit_m_s, digits: 3) } m/s
report-restarts = Neustarts
report-restarts-none = die Überwachung stoppte den Roboter nie
report-restarts-some = die Überwachung stoppte den Roboter

# Lastparameter
report-parameters = Trägheitsparameter
report-parameters-note = ± hinter dem Wert von Heft ist die Hälfte des 95-%-Intervalls; hinter dem der Veröffentlichung eine Standardabweichung, wie deren Gl. (8)-(10) sie angeben.
report-reference-source = Referenz: { $source }.
report-paper = Verfahren der Veröffentlichung
report-ours = Heft
report-paper-error = Fehler der Veröffentlichung
report-our-error = Fehler von Heft
report-outside = Farbig: die Referenz liegt außerhalb des 95-%-Intervalls. Entweder stimmt die Referenz nicht oder das Modell der Messung.
report-budget = Woher die Unsicherheit kommt
report-budget-note = Anteil an der Varianz jedes Parameters. Die Wiederholbarkeit ist, was diese Aufzeichnung offenlässt (Typ A); alles andere bleibt von Lauf zu Lauf gleich (Typ B), und keine Wiederholung beseitigt es. Einheiten wie in der Tabelle oben.
report-budget-measured = gemessen
report-budget-stated = angegeben
report-budget-assumed = angenommen
report-budget-repeats = wiederholt sich auf ± (95 %)
report-budget-total = mit allem, ± (95 %)
report-workpiece-alone = Werkstück allein
report-workpiece-note = Die Tabelle darüber gilt für das Ganze, das der Sensor spürt. Hier ohne { $tools }; ± ist die Hälfte des 95-%-Intervalls und enthält die angegebene Unsicherheit der Werkzeuge.
report-tool = { $title } ({ SIGNIFICANT($mass_kg, digits: 4) } kg)
report-workpiece = Werkstück

# Sensor
report-sensor = Kraft-Momenten-Sensor
report-sensor-note = Rest: Messung minus Rekonstruktion. Wo er das Rauschen übersteigt, wirkt etwas, das im Modell fehlt.
report-offset = Nullpunkt
report-residual-rms = Rest (Effektivwert)
report-noise-std = Rauschen (Std.-Abw.)
report-ratio = Verhältnis
report-unseen = Bewegungen, die nicht in die Schätzung eingingen
report-rotation-about = Drehung um { $axis }
report-unseen-holds = { $motion }, nicht in die Schätzung eingegangen: vorhergesagt auf { $rms } genau (Effektivwert), das { FIXED($ratio) }-fache der { $expected }, die nach Rauschen und eigener Unsicherheit der Vorhersage zu erwarten sind. Das Ergebnis bewährt sich an ihr.
report-unseen-fails = { $motion }, nicht in die Schätzung eingegangen: vorhergesagt auf { $rms } genau (Effektivwert), das { FIXED($ratio) }-fache der { $expected }, die nach Rauschen und eigener Unsicherheit der Vorhersage zu erwarten sind. Das Ergebnis bewährt sich an ihr nicht: es wirkt etwas, das im Modell fehlt.
report-force-and-torque = { SIGNIFICANT($force_n, digits: 2) } N und { SIGNIFICANT($torque_n_m, digits: 2) } N m

# Bilder
report-wrench = Kraft und Moment, gemessen und rekonstruiert
report-wrench-caption = Breite graue Linie: gemessen, Nullpunkt abgezogen. Dünne Linie: aus den bestimmten Parametern rekonstruiert. Jeweils darunter: der Rest in Standardabweichungen des Rauschens, mit dem Band von ±3. Schattiert: Drehungen um die Sensorachse, die darüber steht.
report-rotations = Drehungen
report-rotations-caption = Winkelgeschwindigkeit und -beschleunigung um die Drehachse, grau um die beiden anderen, und das Moment um diese Achse: gemessen (breit, grau) und rekonstruiert (dünn).
report-about-axis = um Sensorachse { $axis }
report-rotation-time = Zeit in der Drehung, s
report-residual-sigma = Rest, σ
report-distance = Abstand
report-distance-caption = Kleinster Abstand von Roboter und Hüllquader der Last zu Hindernissen und Schutzzonen, ohne die Glieder, die nur das erste Gelenk bewegt: deren Abstand ändert sich kaum.
report-distance-axis = Abstand, m
report-distance-limit = Grenze { FIXED($limit_m, digits: 3) } m

# Startstellungen
report-starts = Startstellungen
report-starts-note = Hindernisse sind grau, Schutzzonen gestrichelt, der Hüllquader der Last umrandet. x y z: Sensorachsen; die genannte Achse zeigt längs der Schwerkraft (+) oder gegen sie (−). Gepunktete Pfeile: wohin eine Last flöge, die sich am Anfang löst.
report-scene = Roboter in Startstellung { $axis }, { FIXED($clearance_m, digits: 3) } m von „{ $nearest }“
report-throw = Flug
report-start-clear = { FIXED($clearance_m, digits: 3) } m frei (am nächsten: { $nearest }), Manipulierbarkeit { FIXED($manipulability, digits: 3) }
report-start-clear-turning = { FIXED($clearance_m, digits: 3) } m frei, in der Drehung { FIXED($turning_m, digits: 3) } m (am nächsten: { $nearest }), Manipulierbarkeit { FIXED($manipulability, digits: 3) }
report-start-joints = Gelenke { $angles }
report-start-throw = eine Last, die sich löst, fliegt in { FIXED($distance_m) } m Abstand an „{ $zone }“ vorbei ({ FIXED($speed_m_s) } m/s)

# Zweite Prüfung
report-opinion = Ein zweites Mal geprüft
report-opinion-note = { $samples } Sollwerte, vor der Freigabe noch einmal vermessen, mit einem Programm und einer Kollisionsbibliothek, die der Planer nicht benutzt.
report-opinion-least = gemessen
report-opinion-between = zwischen
report-opinion-where = wo und wann
report-opinion-left-out = Paare, die nicht beurteilt werden, und warum
report-opinion-when = { $part }, { FIXED($time_s, digits: 1) } s
report-opinion-fastest = schnellster Punkt
report-opinion-corner = eine Ecke von { $body }
report-opinion-lost-load = eine Last, die sich löst
report-body-payload = Last
report-body-floor = Boden
report-opinion-flight = ihr Flug - Zone { $zone }
report-pair-environment = zu Hindernissen, Zonen und Boden
report-pair-first-link = erstes Glied zu Hindernissen, Zonen und Boden
report-pair-mount = erste Glieder zu dem, worauf der Roboter steht
report-pair-payload = Last zu Gliedern
report-pair-links = Glieder zueinander
report-pair-near = durch den Bau nah beieinander
report-pair-joined = ausgelassen

# Herkunft
report-origin = Wie es dazu kam
report-recording = Aufzeichnung
report-samples = { $count } Abtastungen
report-rate = { FIXED($span_s, digits: 1) } s, im Mittel { SIGNIFICANT($rate_hz, digits: 4) } je Sekunde
report-measured = Gemessen
report-wrist-wrench = Kräfte am Handgelenk
report-joint-torques = Gelenkmomente
report-with-joints = mit Gelenkstellungen
report-with-poses = mit Stellungen des Sensors
report-planning = Planung
report-robot-time = Roboterzeit
report-estimation = Schätzung
report-seed = Startwert
report-seed-note = von Planung und Simulation
report-source = Quelle der Aufzeichnung: { $source }

# Diagnose: Kopf und das Wichtigste
report-gap-none = Keine Abweichung von Belang
report-gap-explained = Abweichung erklärt
report-gap-ambiguous = Abweichung auf mehr als eine Weise erklärt
report-gap-unknown = Abweichung unbekannter Ursache
report-gap-not-enough = Zu wenig, um etwas zu sagen
report-gap-under = Diagnose der Abweichung zwischen einer Aufzeichnung und der Simulation desselben Laufs
report-gap-under-with-twin = Diagnose der Abweichung zwischen einer Aufzeichnung und der Simulation desselben Laufs. Der Zwilling der Zelle hatte bereits: { $effects }
report-gap-to-do = Was zu tun ist
report-gap-for-payload = Für die Last
report-gap = Abweichung
report-gap-noise-is-one = Rauschen allein ist 1
report-gap-with-effect = Abweichung mit dem Effekt
report-gap-with-best-effect = Abweichung mit dem besten Effekt
report-gap-on-unseen = an Bewegungen, die die Anpassung nicht sah
report-gap-probability = Wahrscheinlichkeit
report-gap-of-unknown = eines unbekannten Effekts
report-gap-of-effect = Effekt: { $effect }
report-gap-closure = Geschlossen
report-gap-closure-interval = 95 %: { PERCENT($low) } bis { PERCENT($high) } %
report-gap-largest-in = Am größten in
report-gap-during = während: { $phase }
report-gap-during-at-stage = während: { $phase }; Stufe: { $stage }
report-gap-stage-sensor = Sensor
report-gap-stage-timing = Zeitbezug
report-gap-stage-mounting = Montage
report-gap-stage-kinematics = Kinematik
report-gap-stage-payload = Last
report-gap-stage-environment = Umgebung
report-gap-stage-actuation = Antriebe
report-gap-made-by = Berechnet von Heft { $version } in { FIXED($seconds, digits: 1) } s. Eine Diagnose ist ein Rat: sie ändert weder die Aufzeichnung noch die Zelle, und Heft ist keine Sicherheitsfunktion (safety_rated: false).

# Was zu tun ist
report-gap-do-nothing = In die Simulation muss nichts aufgenommen werden.
report-gap-record-again = Zeichnen Sie noch einmal auf, mit dem, was fehlt.
report-gap-add-none = Nehmen Sie keinen Effekt in die Simulation auf: keiner von ihnen ist die Ursache.
report-gap-add-none-look = Nehmen Sie keinen Effekt in die Simulation auf: keiner von ihnen ist die Ursache. Sehen Sie sich zuerst { $channel } während „{ $phase }“ an.
report-gap-if-it-is = Falls es „{ $effect }“ ist: { $advice }
report-gap-settle-by-motion = Klären Sie zuerst, was davon es ist: siehe unten, was als Nächstes zu messen ist.
report-gap-settle-by = Klären Sie zuerst, was davon es ist: { $splits }
report-gap-settle = Klären Sie zuerst, was davon es ist.

# Wo
report-gap-where = Wo die Abweichung liegt
report-gap-share = Anteil
report-gap-all-bands = alle Frequenzen
report-gap-band = { SIGNIFICANT($low_hz, digits: 6) } bis { SIGNIFICANT($high_hz, digits: 6) } Hz
report-gap-heat-note = Groß: Effektivwert von Aufzeichnung minus Simulation als Vielfaches ihres Rauschens. Klein: Anteil an der ganzen Abweichung. Beides gilt für gemittelte Zeilen, deren Rauschen gering ist; darum sind die Werte größer als die Abweichung, die für einzelne Messwerte gilt. Aufgeführt sind die { $count } größten Stellen, { PERCENT($share) } % der Abweichung; leere Stellen enthalten je weniger.
report-gap-heat-note-of-bands = Groß: Effektivwert von Aufzeichnung minus Simulation als Vielfaches ihres Rauschens, unter „alle Frequenzen“ der des lautesten Bands. Klein: Anteil an der ganzen Abweichung. Beides gilt für gemittelte Zeilen, deren Rauschen gering ist; darum sind die Werte größer als die Abweichung, die für einzelne Messwerte gilt. Aufgeführt sind die { $count } größten Stellen, { PERCENT($share) } % der Abweichung; leere Stellen enthalten je weniger.
report-gap-over-time = Anteil über der Zeit, %
report-gap-start = Anfang
report-gap-end = Ende der Aufzeichnung
report-gap-by-direction = Nach Drehrichtung und nach der Achse, die nach oben oder unten zeigt, × Rauschen
report-gap-positive = Drehung positiv
report-gap-negative = Drehung negativ
report-gap-still = Stillstand
report-gap-axis-down = { $axis } nach unten
report-gap-axis-up = { $axis } nach oben
report-gap-on-joints = Auf der Seite der Gelenke
report-gap-tracking = Schleppfehler in Bewegung
report-gap-torque = nicht erklärtes Moment

# Welcher Effekt
report-gap-which = Welcher Effekt die Ursache ist
report-gap-effects = Effekte
report-gap-probability-column = Wahrscheinlichkeit
report-gap-closure-column = geschlossen (95 %)
report-gap-gap-after = Abweichung danach
report-gap-size-column = Größe, ± eine Standardabweichung
report-gap-percent-range = { PERCENT($low) } bis { PERCENT($high) } %
report-gap-no-effect = kein Effekt
report-gap-not-in-library = etwas, das die Bibliothek nicht hat
report-gap-at-bound = { $parameter } (an der Grenze des Plausiblen)
report-gap-more-parameters = und { $count } weitere, weniger deutlich
report-gap-closure-note = Geschlossen: der Anteil der Abweichung über dem Rauschen, der verschwindet, sobald der Effekt in der Simulation ist.
report-gap-no-effects-note = Ein Effekt von Belang stünde hier.
report-gap-effect-closes = { $effect } { PERCENT($closure) } %
report-gap-likely = In neun von zehn Fällen wie diesem ist es eines davon: { $effects }.
report-gap-others =
    Nicht gezeigt: { $count ->
        [one] 1 weiterer Effekt,
       *[other] { $count } weitere Effekte, zusammen
    } { $share }. Geschlossen hätten: { $closed }.
report-gap-others-and-less = Nicht gezeigt: { $count } weitere Effekte, zusammen { $share }. Geschlossen hätten: { $closed }, die übrigen weniger.
report-gap-fewer-parameters = Wie viel ein Effekt schließt, entscheidet nicht allein: von Erklärungen, die gleich gut vorhersagen, ist die mit weniger Parametern die wahrscheinlichere.
report-gap-other-pairs =
    Nicht gezeigt: { $count ->
        [one] 1 weitere Kombination,
       *[other] { $count } weitere Kombinationen, zusammen
    } { $share }; das beste ({ $effects }) schließt { PERCENT($closure) } %.
report-gap-ties = Was diese Aufzeichnung nicht trennen kann
report-gap-apart = { FIXED($sigma, digits: 1) } σ auseinander
report-gap-settled-by = Das würde es entscheiden: { $splits }

# Was als Nächstes zu messen ist
report-gap-next = Was als Nächstes zu messen ist
report-gap-takes = Roboterzeit { FIXED($time_s, digits: 0) } s.
report-gap-planned = Die Bewegung ist in der Zelle geplant.
report-gap-not-planned = Die Bewegung ist noch nicht geplant: { $reason }
report-gap-pair = „{ $first }“ von „{ $second }“
report-gap-tells-apart = Sie unterscheidet { $pairs }: jetzt { FIXED($before, digits: 1) } σ auseinander, mit beiden Aufzeichnungen voraussichtlich { FIXED($after, digits: 0) } σ.

# Wie weit sie sich schließt
report-gap-shrinks = Wie weit sich die Abweichung schließt
report-gap-from-to = Vom { FIXED($before) }-fachen auf das { FIXED($after) }-fache des Rauschens, an Bewegungen, die die Anpassung nicht sah.
report-gap-size = Wie groß die Abweichung ist
report-gap-times = Das { FIXED($before) }-fache des Rauschens. Von Belang ist eine Abweichung ab 2, oder wo sie die Last verändert.
report-gap-times-and-after = Das { FIXED($before) }-fache des Rauschens; das { FIXED($after) }-fache mit allem, was gefunden wurde, in der Simulation. Von Belang ist eine Abweichung ab 2, oder wo sie die Last verändert.
report-gap-by-channel = Abweichung jedes Kanals vorher und nachher
report-gap-noise = Rauschen
report-gap-axis = Abweichung, Rauschen = 1
report-gap-bars-effect = Oberer Balken: vorher. Unterer Balken: mit dem Effekt; farbig, wo mehr als das Doppelte des Rauschens bleibt. Gestrichelt: Rauschen allein. Jede dieser Bewegungen wurde aus den anderen vorhergesagt: { $motions }.
report-gap-bars-best-effect = Oberer Balken: vorher. Unterer Balken: mit dem besten Effekt der Bibliothek; farbig, wo mehr als das Doppelte des Rauschens bleibt. Gestrichelt: Rauschen allein. Jede dieser Bewegungen wurde aus den anderen vorhergesagt: { $motions }.
report-gap-bars-detected = Oberer Balken: vorher. Unterer Balken: mit allem, was gefunden wurde; farbig, wo mehr als das Doppelte des Rauschens bleibt. Gestrichelt: Rauschen allein. Jede dieser Bewegungen wurde aus den anderen vorhergesagt: { $motions }.
report-gap-worst = Die schlechteste Bewegung: { $channels } während „{ $phase }“
report-gap-overlay = Kraft und Moment, gemessen und simuliert
report-gap-rest-axis = Rest, σ
report-gap-key-measured = gemessen, Nullpunkt abgezogen
report-gap-key-before = simuliert, vorher
report-gap-key-after = simuliert mit dem Effekt
report-gap-key-simulated = simuliert
report-gap-overlay-note = Darunter: Messung minus Simulation in Standardabweichungen des Rauschens, mit dem Band von ±3. Farbig: mehr, als Rauschen sein kann.

# Last
report-gap-payload = Last
report-gap-payload-moved = Last vorher und nachher
report-gap-payload-note = ± eine Standardabweichung.
report-gap-payload-moved-note = Änderung: nachher minus vorher, als Anteil der Masse, des Betrags des statischen Moments, des größten Trägheitsmoments; und in 95-%-Intervallen beider Werte zusammen, wobei bis 1 nichts Signifikantes ist. Farbig: eine Änderung von Belang.
report-gap-payload-untrusted = „Nachher“ ist mit dem besten Effekt der Bibliothek, der nicht die Ursache ist: keiner der beiden Spalten ist zu trauen.
report-gap-before = vorher
report-gap-after = nachher
report-gap-change = Änderung
report-gap-in-intervals = × Intervall
report-gap-value = Wert

# Daneben
report-gap-also = Anderswo gesehen als in Kraft und Moment
report-gap-also-note = Es erklärt keine Abweichung zwischen Simulation und Aufzeichnung und wird mit eigenem Maß beurteilt.
report-gap-side-joints = an den Gelenken
report-gap-side-reading = in den Messwerten des Sensors
report-gap-side-reference = gegen die Referenzlast
report-gap-times-expected = { $side }; das { FIXED($times, digits: 1) }-fache des Angegebenen oder Geduldeten
report-gap-does-not-matter = Ohne Belang.
report-gap-minor = Gefunden, aber ohne Belang
report-gap-limits = Was diese Aufzeichnung nicht sagen kann

# Was die Momente der Gelenke sagen
report-joints = Gelenke
report-joints-note = Was die Momente über die Gelenke selbst sagen: Reibung, um wie viel jedes Moment zu viel anzeigt mit seinem 95-%-Intervall, und was nichts erklärt, quadratisches Mittel.
report-joints-coulomb = Coulomb, N m
report-joints-viscous = viskos, N m s/rad
report-joints-gain = Verstärkung daneben, %
report-joints-residual = unerklärt, N m
report-joints-windows = Fenster
