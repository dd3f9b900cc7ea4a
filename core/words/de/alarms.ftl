# Alarme: was einen Menschen braucht, und was zu tun ist.
alarms-run-aborted = Lauf abgebrochen: { $cause }
alarms-run-aborted-do = Zelle prüfen, dann den Lauf quittieren. Bis dahin beginnt in dieser Zelle kein anderer Lauf.
alarms-sensor-lost = Kraftsensor: { $cause }
alarms-sensor-lost-do = Sensor, Kabel und Stromversorgung prüfen. Dann den Lauf quittieren.
alarms-robot-lost = Roboter: { $cause }
alarms-robot-lost-do = Verbindung zum Roboter und seine Steuerung prüfen. Dann den Lauf quittieren.
alarms-run-held = Lauf angehalten: { $cause }
alarms-run-held-do = Mit „Fortfahren“ fortsetzen oder stoppen. Hat niemand die Bedienung, endet der Lauf von selbst.
alarms-run-blocked = Der Weg ist blockiert: { $in_the_way }.
alarms-run-blocked-do = Weg frei machen. Der Roboter fährt von selbst weiter.
alarms-run-stopped = Lauf gestoppt: { $cause }
alarms-run-stopped-do = Der Roboter steht dort, wo er gestoppt wurde. Prüfen, dann den Lauf fortsetzen oder einen neuen beginnen.
alarms-order-waits = Ein Auftrag von { $sender } wartet auf die Freigabe.
alarms-order-waits-do = Plan an der Zelle prüfen, dann freigeben oder den Auftrag stornieren.
alarms-store-away = Die Datenbank ist nicht verfügbar.
alarms-store-away-do = Datenbank und Festplatte prüfen. Solange sie fehlt, wird nichts freigegeben; was inzwischen geschieht, wird aufbewahrt und nachgetragen.
alarms-disk-full = Die Festplatte ist voll: { FIXED($free_mb, digits: 0) } MB frei.
alarms-disk-full-do = Platz im Datenordner schaffen. Bis dahin wird kein Lauf freigegeben.
alarms-disk-nearly-full = Die Festplatte ist fast voll: { FIXED($free_mb, digits: 0) } MB frei.
alarms-disk-nearly-full-do = Platz im Datenordner schaffen, bevor sich Läufe nicht mehr aufzeichnen lassen.
alarms-webhook-failing = { $url } nimmt nichts an, bisher { $attempts } Versuche: { $cause }
alarms-webhook-failing-do = Adresse und Empfängersystem prüfen. Die Meldungen werden drei Tage lang erneut gesendet.
alarms-cell-flawed = Zelle { $cell } ist nicht verwendbar: { $flaw }
alarms-cell-flawed-do = Dateien der Zelle berichtigen oder die Schutzzone zurückstellen.

# Was zu einem Alarm nicht passt.
alarms-unknown = Alarm: keiner der offenen heißt „{ $alarm }“. Sehen Sie nach, welche offen sind.
alarms-acknowledged-already = Alarm { $alarm }: wurde schon quittiert, von { PERSON($who) }
