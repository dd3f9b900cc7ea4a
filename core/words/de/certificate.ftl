# The certificate of a run: one page for the record.
certificate-title = Zertifikat der Nutzlastbestimmung
certificate-not-stated = nicht angegeben
certificate-payload = Nutzlast
certificate-sensor = Sensor
certificate-sensor-in-frame = { $name }, Koordinatensystem '{ $frame }', Messbereich { $range }
certificate-calibration = Kalibrierung
certificate-calibration-stated = { $source }: Kennwert u = { $gain }, Übersprechen u = { $crosstalk } des Messbereichs
certificate-calibration-assumed = { $size } (angenommen)
certificate-recording = Aufzeichnung (SHA-256)
certificate-version = Heft { $version }
# Values
certificate-values = Werte mit Messunsicherheit
certificate-symbol = Größe
certificate-value = Wert
certificate-expanded = U (95 %)
certificate-repeatability = U, Typ A
certificate-unit = Einheit
certificate-mostly = Größte Beiträge (Anteil an der Varianz)
certificate-contribution = { $source } { PERCENT($share) } %
certificate-not-determined = nicht bestimmt
certificate-reason = { $names } nicht bestimmt: { $reason }
certificate-frame = Für alles, was der Sensor trägt, im Sensorkoordinatensystem '{ $frame }': Masse m, Schwerpunkt c, Trägheit I um den Schwerpunkt. U = { FIXED($factor, digits: 2) } u ist die erweiterte Messunsicherheit für eine Überdeckungswahrscheinlichkeit von 95 %, alle Beiträge zusammen (Typ A und B, JCGM 100:2008); daneben die der Wiederholbarkeit allein (Typ A).
certificate-workpiece = Ohne { $tools }: m = { $mass }; c = { $com }; I = { $inertia }.
certificate-workpiece-unknown = Ohne { $tools }: nicht bestimmt.
certificate-twin = Berücksichtigte Effekte aus dem Zwilling der Zelle: { $effects }.
# What was assumed
certificate-remarks = Annahmen und Hinweise
certificate-no-remarks = Keine Annahme von Gewicht, keine Warnung.
certificate-no-budget = das Ergebnis stammt aus einer früheren Version: seine Unsicherheit ist die Wiederholbarkeit allein (Typ A), ohne die der Sensorkalibrierung
# Statement of conformity
certificate-conformity = Konformitätsaussage
certificate-conforms = Konform.
certificate-conforms-to-assumed = Konform mit einer angenommenen Schwelle.
certificate-not-shown = Konformität nicht nachgewiesen.
certificate-not-judged-at-all = Keine Aussage.
certificate-margin = Reserve: Faktor { SIGNIFICANT($margin, digits: 2) } auf jede Unsicherheit.
certificate-rule = Entscheidungsregel (JCGM 106:2012, ISO/IEC Guide 98-4): Konformität wird festgestellt, wenn der Fehler der Werte mit einer Wahrscheinlichkeit von mindestens { PERCENT($probability) } % zu jeder Zeit der Bewegung unter jeder Schwelle der Zelle bleibt (Risiko einer falschen Annahme höchstens { PERCENT($risk) } %). Berechnet mit { $draws } Ziehungen aus der Kovarianz, alle Beiträge zusammen, über { FIXED($motion_s, digits: 0) } s Bewegung, so zügig wie die Grenzen der Zelle zulassen.
certificate-no-cell = Die Zelle liegt nicht vor, ihre Schwellen sind daher nicht bekannt.
certificate-nothing-identified = Es wurde nichts bestimmt.
certificate-not-judged = Die Zelle ist nicht verwendbar: { $reason }
# Acceptance
certificate-acceptance = Annahme
certificate-place = Ort, Datum
certificate-signature = Name, Unterschrift
certificate-data = Dasselbe als Daten: JSON, Format { $format }, SHA-256
certificate-disclaimer = Heft ist keine Sicherheitsfunktion (safety_rated: false), und dies ist kein Kalibrierschein: Die Werte sind so weit rückführbar wie die Kalibrierung des oben genannten Sensors.
# What the command cannot do
certificate-nothing-asked =
    .found = weder --json noch --pdf
    .expected = mindestens eines davon: wohin das Zertifikat geschrieben wird
