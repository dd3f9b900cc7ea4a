store-unavailable = die Datenbank ist gesperrt, voll oder fort; nichts wurde geändert. Versuchen Sie es noch einmal; bleibt es so, sehen Sie im Protokoll des Dienstes nach
store-release-waits = Freigabe: die Datenbank ist gesperrt, voll oder fort, und ohne sie bewegt sich nichts; geben Sie noch einmal frei, wenn sie wieder da ist
store-release-not-taken = Freigabe: die Datenbank nahm sie nicht an, darum bewegt sich nichts; der Lauf wurde beendet
store-resume-waits = Fortfahren: die Datenbank ist gesperrt, voll oder fort, und ohne sie beginnt keine Bewegung; lassen Sie den Lauf fortfahren, wenn sie wieder da ist
store-result-not-there = Lauf { $run }: die Datenbank hat sein Ergebnis noch nicht; nehmen Sie es in einigen Sekunden noch einmal an
