payload-not-ten-numbers =
    .found = { $values }
    .expected = zehn endliche Zahlen [{ $names }]
payload-runs-nothing-in-common = Die Läufe haben keine Größe gemeinsam und lassen sich nicht vergleichen.
payload-runs-agree = Kein bedeutsamer Unterschied: ein mindestens so großer zeigt sich in { PERCENT($chance) } % der Wiederholungen mit derselben Last.
payload-runs-differ = Die Läufe unterscheiden sich stärker als durch Zufall ({ SIGNIFICANT($chance, digits: 1) }), am deutlichsten in { $parameter } um { SIGNIFICANT($difference, digits: 3) } { $unit }, das { FIXED($times, digits: 1) }-fache seiner Unsicherheit.
payload-conditions-of-other-runs =
    .found = { $count ->
        [one] { $count } Bedingung
       *[other] { $count } Bedingungen
    }
    .expected = eine für jeden der { $runs } Läufe
payload-series-of-nothing =
    .found = Läufe, die nichts bestimmen
    .expected = mindestens einer, der die Masse bestimmt
payload-series-of-one = Ein einziger Lauf stimmt mit sich selbst überein. Wie sehr Läufe streuen, zeigen erst mehrere.
payload-series-agrees = Die { $runs } Läufe stimmen überein: mindestens so große Unterschiede zeigen { PERCENT($chance) } % der Reihen mit derselben Last.
payload-series-differs = Die { $runs } Läufe streuen stärker, als sie angeben (Wahrscheinlichkeit { SIGNIFICANT($chance, digits: 1) }); darüber hinaus um { $scatter }. Das Intervall des Mittelwerts berücksichtigt es.
payload-scatter-mass = { SIGNIFICANT($std, digits: 2) } kg
payload-scatter-first-moment = { SIGNIFICANT($std, digits: 2) } kg m
payload-scatter-inertia = { SIGNIFICANT($std, digits: 2) } kg m²
payload-few-runs = die Streuung zwischen { $runs } Läufen ist kaum bekannt: erst fünf und mehr zeigen sie
payload-one-condition = alle Läufe gelten als unter einer Bedingung gemacht: geben Sie Bedingungen an (Tag, Plan, Roboter), um die Vergleichbarkeit zu sehen
payload-mostly-prior = eher vorher bekannt als gemessen: { $parameters }
