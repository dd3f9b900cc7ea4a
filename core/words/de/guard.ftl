# Stopps der Überwachung. $value und $limit: was gemessen oder befohlen war, und womit es verglichen wurde.
guard-state-not-finite = der Zustand des Roboters enthält Werte, die keine Zahlen sind; der Roboter wurde gestoppt. Prüfen Sie die Verbindung zu Roboter und Sensor und beginnen Sie noch einmal.
guard-command-not-finite = die befohlene Stellung enthält Werte, die keine Zahlen sind; der Roboter wurde gestoppt. Prüfen Sie die Verbindung zu Roboter und Sensor und beginnen Sie noch einmal.
guard-state-stale = die Uhr des Roboters ging in einer Periode um { MILLI($value, digits: 2) } ms weiter (erwartet { MILLI($limit, digits: 2) } ms), sein Zustand ist veraltet; der Roboter wurde gestoppt. Prüfen Sie die Verbindung zum Roboter und beginnen Sie noch einmal.
guard-state-late = der Zustand des Roboters kam nach { MILLI($value, digits: 1) } ms (Grenze { MILLI($limit, digits: 1) } ms); der Roboter wurde gestoppt. Entlasten Sie den Rechner oder sein Netz und beginnen Sie noch einmal.
guard-joint-position = Gelenk { $joint } steht bei { FIXED($value, digits: 4) } rad (Grenze { FIXED($limit, digits: 4) } rad); der Roboter wurde gestoppt. Führen Sie ihn von Hand zurück und planen Sie neu.
guard-joint-position-commanded = Gelenk { $joint } sollte auf { FIXED($value, digits: 4) } rad (Grenze { FIXED($limit, digits: 4) } rad); der Roboter wurde gestoppt. Planen Sie neu.
guard-joint-speed = Gelenk { $joint } bewegt sich mit { FIXED($value, digits: 3) } rad/s (Grenze { FIXED($limit, digits: 3) } rad/s); der Roboter wurde gestoppt. Planen Sie neu.
guard-joint-speed-commanded = Gelenk { $joint } sollte sich mit { FIXED($value, digits: 3) } rad/s bewegen (Grenze { FIXED($limit, digits: 3) } rad/s); der Roboter wurde gestoppt. Planen Sie neu.
guard-speed = { $body } bewegt sich mit { FIXED($value, digits: 3) } m/s (Grenze { FIXED($limit, digits: 3) } m/s); der Roboter wurde gestoppt. Planen Sie neu.
guard-speed-commanded = { $body } sollte sich mit { FIXED($value, digits: 3) } m/s bewegen (Grenze { FIXED($limit, digits: 3) } m/s); der Roboter wurde gestoppt. Planen Sie neu.
guard-force = { $channel } von { $sensor } ist { FIXED($value, digits: 2) } N (Messbereich { FIXED($limit, digits: 2) } N); der Roboter wurde gestoppt. Prüfen Sie, ob er etwas berührt, oder nehmen Sie eine leichtere Last oder einen größeren Sensor.
guard-torque = { $channel } von { $sensor } ist { FIXED($value, digits: 2) } N m (Messbereich { FIXED($limit, digits: 2) } N m); der Roboter wurde gestoppt. Prüfen Sie, ob er etwas berührt, oder nehmen Sie eine leichtere Last oder einen größeren Sensor.
guard-joint-off-command = Gelenk { $joint } ist { FIXED($value, digits: 4) } rad von seinem Befehl entfernt (Grenze { FIXED($limit, digits: 4) } rad); der Roboter wurde gestoppt. Prüfen Sie den Regler des Gelenks und die eingestellte Last und beginnen Sie noch einmal.
guard-wrench-frozen = Kraft und Moment haben sich { FIXED($value, digits: 3) } s lang nicht geändert (Grenze { FIXED($limit, digits: 3) } s), ein lebender Sensor rauscht; der Roboter wurde gestoppt. Prüfen Sie den Anschluss des Sensors und beginnen Sie noch einmal.

# Abstände: der jetzige, und der des Ortes, an dem der Roboter stünde, wenn er jetzt bremste.
guard-too-close = { $first } ist { FIXED($value, digits: 5) } m von { $second } entfernt (Grenze { FIXED($limit, digits: 3) } m); der Roboter wurde gestoppt. Planen Sie neu.
guard-too-close-to-zone = { $first } ist { FIXED($value, digits: 5) } m von { $second } entfernt (Grenze { FIXED($limit, digits: 3) } m); der Roboter wurde gestoppt. Räumen Sie die Zone und beginnen Sie noch einmal.
guard-too-close-to-obstacle = { $first } ist { FIXED($value, digits: 5) } m von { $second } entfernt (Grenze { FIXED($limit, digits: 3) } m); der Roboter wurde gestoppt. Prüfen Sie, wo es steht, und planen Sie neu.
guard-would-stop-too-close = { $first } käme erst { FIXED($value, digits: 5) } m vor { $second } zum Stehen (Grenze { FIXED($limit, digits: 3) } m); der Roboter wurde gestoppt. Planen Sie neu.
guard-would-stop-too-close-to-zone = { $first } käme erst { FIXED($value, digits: 5) } m vor { $second } zum Stehen (Grenze { FIXED($limit, digits: 3) } m); der Roboter wurde gestoppt. Räumen Sie die Zone und beginnen Sie noch einmal.
guard-would-stop-too-close-to-obstacle = { $first } käme erst { FIXED($value, digits: 5) } m vor { $second } zum Stehen (Grenze { FIXED($limit, digits: 3) } m); der Roboter wurde gestoppt. Prüfen Sie, wo es steht, und planen Sie neu.
