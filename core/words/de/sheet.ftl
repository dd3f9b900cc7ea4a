# Das Wertungsblatt der Blindversuche und seine Bilder
sheet-title = Blindversuche
sheet-command = `heft trial --seeds { $seeds }` ({ $count ->
        [one] 1 Versuch
       *[other] { $count } Versuche
    }, Heft { $versions }).
sheet-how = Die Fehler baut ein Programm ein, das mit den Effekten nichts gemeinsam hat; jede Antwort wurde vor der ersten Diagnose versiegelt (ihr Hash ausgegeben). Anteile stehen mit ihrem 95-%-Intervall (Wilson). Ein Fehler zählt, wenn er von Belang ist und mindestens { FIXED($sigma, digits: 0) } Sigma von nichts entfernt (`core/trial/judgement.py`). Wie weit ein Fehler von nichts entfernt ist, zeigt derselbe Lauf ohne ihn, noch einmal simuliert; wie weit von seinem nächsten Rivalen, eine Anpassung der Rivalen an das, was der wahre Effekt vorhersagt.
sheet-by-kind = Nach Art
sheet-by-effect = Nach Effekt
sheet-not-right = Nicht richtig
sheet-all-right = Keiner.
sheet-confusion-numbers = Verwechslungen in Zahlen

# Die Kennzahlen
sheet-figure = Kennzahl
sheet-wanted = gewünscht
sheet-here = hier
sheet-share = { FIXED($percent, digits: 1) } % ({ $hits } von { $of }; { FIXED($low_percent, digits: 0) }-{ FIXED($high_percent, digits: 0) } %)
sheet-error-by-chance = { $error } (durch Zufall { $low }-{ $high }, wenn jede so oft stimmte, wie sie sagt)
sheet-none-drawn = keiner gezogen
sheet-none = keine
sheet-false-alarms = falscher Alarm bei Läufen ohne Effekt
sheet-one-fault-outright = ein Fehler: ohne Vorbehalt genannt (erklärt durch seinen Namen allein, oder abgelesen neben keiner Abweichung)
sheet-one-fault = ein Fehler: genannt, und nichts sonst
sheet-one-fault-or-tie = dasselbe mit erklärten Gleichständen
sheet-one-fault-after = dasselbe nach der vorgeschlagenen Bewegung ({ $count } verlangten eine)
sheet-verdicts = Befund der richtigen Art: keine Abweichung, ein Name oder unbekannt
sheet-near-rival = nächster Rivale unter { FIXED($sigma, digits: 0) } Sigma: die Wahrheit unter den genannten
sheet-far-rival = nächster Rivale über { FIXED($sigma, digits: 0) } Sigma: ein Name, der richtige
sheet-calibration-first = Kalibrierfehler der ersten Antwort
sheet-calibration-all = Kalibrierfehler aller Klassen ab 1 %
sheet-unknown-as-unknown = Unbekanntes unbekannt genannt
sheet-exact-pair = zwei zugleich: genau das Paar
sheet-parameter-error = Fehler der Parameter, Median von { $count }
sheet-parameters-covered = 95-%-Intervalle der Parameter enthalten die Wahrheit
sheet-closure-ratio = geschlossener Anteil im Verhältnis zum wahren Effekt, Median
sheet-closure-ratio-low = geschlossener Anteil im Verhältnis zum wahren Effekt, 10. Perzentil
sheet-payload-before = Fehler der Last vorher, Median der beantworteten Versuche
sheet-payload-after = Fehler der Last nachher
sheet-payload-covered = 95-%-Intervalle der Last enthalten die Wahrheit
sheet-seconds = Diagnose auf einem Prozessorkern, Median
sheet-the-noise = das Rauschen: { $stated }

# Nach Art und nach Effekt
sheet-kind = Art
sheet-kind-none = keiner
sheet-kind-single = einer
sheet-kind-double = zwei
sheet-kind-unknown = unbekannt
sheet-trials = Versuche
sheet-count = zählen
sheet-right-of-counting = richtig von denen, die zählen
sheet-right-of-all = richtig von allen
sheet-immaterial = ohne Belang
sheet-no-answer = ohne Antwort
sheet-effect = Effekt
sheet-named = genannt, ob von Belang oder nicht
sheet-halfway-size = Größe, bei der die Hälfte genannt wird
sheet-halfway-sigma = dasselbe in Sigma von nichts
sheet-below = unter { SIGNIFICANT($size, digits: 2) }
sheet-above = über { SIGNIFICANT($size, digits: 2) }

# Was nicht richtig war
sheet-planted-faults = { $faults }, Größe { FIXED($size) }
sheet-planted-faults-at-sigma = { $faults }, Größe { FIXED($size) }, { FIXED($sigma, digits: 0) } Sigma (von Belang ab { FIXED($material_sigma, digits: 0) })
sheet-failure = { $fault }, { $cell }, { $payload }: { $answer }
sheet-answer-beside = { $answer }, daneben { $effects }
sheet-answer-gap = { $answer }, Abweichung { FIXED($before) } auf { FIXED($after) }
sheet-does-not-count = { $line } (zählt nicht)
sheet-verdict-no-gap = keine Abweichung
sheet-verdict-explained = erklärt
sheet-verdict-ambiguous = mehrdeutig
sheet-verdict-unknown = unbekannt
sheet-verdict-not-enough = zu wenig
sheet-verdict-stopped = gestoppt

# Bilder
sheet-confusion = Verborgen gegen geantwortet, einzelne Fehler, die zählen
sheet-calibration = Kalibrierung
sheet-closure = Wie weit sich die Abweichung schließt
sheet-detection = Was zu sehen ist und gesehen wurde
sheet-planted = verborgen
sheet-answered = geantwortet
sheet-times = Anzahl
sheet-most-probable-class = wahrscheinlichste Klasse
sheet-every-class = jede Klasse ab 1 %
sheet-probability-given = genannte Wahrscheinlichkeit (Zahlen: Antworten)
sheet-share-right = Anteil richtiger
sheet-closure-of-truth = geschlossen vom wahren Effekt
sheet-closure-of-first = geschlossen vom ersten Namen
sheet-distance-from-nothing = Entfernung von nichts, Sigma (gefüllt: genannt; gestrichelt: 3 Sigma)
