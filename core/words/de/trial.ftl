# Blindversuche
trial-dask-missing =
    .found = kein Paket `distributed`
    .expected = dass es installiert ist: pip install 'heft[dask]'
trial-no-scheduler =
    .found = kein Scheduler ({ $reason })
    .expected = die Adresse eines laufenden Dask-Schedulers
trial-not-a-run =
    .found = etwas, das keine Reihe von Versuchen ist
    .expected = ein neuer Name, oder der Ordner einer früheren Reihe
trial-no-payload =
    .found = keine Nutzlast
    .expected = mindestens eine, `[payloads.NAME]`, die der virtuelle Roboter tragen soll
trial-line = { $file }, Zeile { $line }
trial-bad-outcome =
    .found = kein Ausgang dieser Version ({ $count ->
        [one] 1 Problem
       *[other] { $count } Probleme
    })
    .expected = ein neuer Ordner
trial-seed = Startwert { $seed }
trial-other-seal =
    .found = das Siegel { $there } im Ordner
    .expected = { $drawn }; nehmen Sie einen neuen
trial-failed = { $error }: { $reason }
trial-planted = { $faults }
trial-planted-nothing = nichts
trial-right = richtig
trial-right-does-not-count = richtig (zählt nicht: zu klein, oder ein anderer Effekt beschreibt es)
trial-not-right = nicht richtig
trial-not-right-does-not-count = nicht richtig (zählt nicht: zu klein, oder ein anderer Effekt beschreibt es)
