payload-not-ten-numbers =
    .found = { $values }
    .expected = zehn endliche Zahlen [{ $names }]
payload-runs-nothing-in-common = Die Läufe haben keine Größe gemeinsam und lassen sich nicht vergleichen.
payload-runs-agree = Kein bedeutsamer Unterschied: ein mindestens so großer zeigt sich in { PERCENT($chance) } % der Wiederholungen mit derselben Last.
payload-runs-differ = Die Läufe unterscheiden sich stärker als durch Zufall ({ SIGNIFICANT($chance, digits: 1) }), am deutlichsten in { $parameter } um { SIGNIFICANT($difference, digits: 3) } { $unit }, das { FIXED($times, digits: 1) }-fache seiner Unsicherheit.
