# Ein KUKA LBR über FRI.
kuka-no-sensor =
    .found = kein Sensor
    .expected = session.sensor (driver, host): Der Arm hat keinen Kraft-Momenten-Sensor am Flansch, und die Identifikation braucht einen. Ohne ihn ist die Last aus Gelenkmomenten zu haben: zwei Aufzeichnungen der Steuerung, heft import, heft identify LOADED --without EMPTY (docs/joint-torques.md)
kuka-no-pad =
    .found = nichts, was sagt, wie der Arm steht: Diese Version der Schnittstelle meldet selbst keine Pose
    .expected = session.pad (q_deg, xyz_mm, abc_deg): Fahren Sie den Arm in eine Pose, in der keine Achse nahe null steht, und lesen Sie Achsen und Flansch vom smartPAD ab
kuka-pad-hides-sign =
    .found = eine Pose, bei der der Flansch derselbe wäre, wenn Achse { $first } andersherum drehte
    .expected = eine Pose in session.pad, bei der jede Achse etwa 10 Grad von null und von den anderen entfernt ist
kuka-pad-hides-order =
    .found = eine Pose, bei der der Flansch derselbe wäre, wenn die Achsen { $first } und { $second } vertauscht wären
    .expected = eine Pose in session.pad, bei der jede Achse etwa 10 Grad von null und von den anderen entfernt ist
kuka-silent = keine Nachricht vom Roboter an { $host } auf Port { $port } dieses Rechners binnen { FIXED($limit_s, digits: 0) } s{ $strange ->
    [none] {""}
   *[other] , wohl aber von { $strange }
  }; nichts hat sich bewegt. Starten Sie die Sunrise-Anwendung, und prüfen Sie, dass sie an die Adresse dieses Rechners und an diesen Port sendet, session.host, und dass keine Firewall dazwischen ist.
kuka-no-line = die Leitung zum Roboter an { $host } auf Port { $port } dieses Rechners ist nicht zu gebrauchen ({ $reason }); nichts hat sich bewegt. Prüfen Sie session.host, session.listen und session.port, ob ein anderes Programm diesen Port hat, und dass die FRI-Version der Steuerung 1.11 bis 2.7 ist.
kuka-period = die Steuerung an { $host } sendet alle { MILLI($found_s, digits: 0) } ms, und session.send_period_ms sagt alle { MILLI($expected_s, digits: 0) } ms; nichts hat sich bewegt. Berichtigen Sie eines von beiden.
kuka-multiplier = die Steuerung an { $host } will nur auf jede { $found }. Nachricht eine Antwort; nichts hat sich bewegt. Setzen Sie den Receive Multiplier der Sunrise-Anwendung auf 1.
kuka-joint-beyond = Gelenk { $joint } steht bei { DEGREES($found) }°, und die URDF der Zelle endet bei { DEGREES($expected) }°; nichts hat sich bewegt. Ist es der Arm der Zelle? Berichtigen Sie die URDF, oder fahren Sie den Arm in seinen Bereich.
kuka-too-fast-for-t1 = er ist in T1, wo kein Punkt schneller sein darf als { FIXED($limit, digits: 2) } m/s, und die Zelle erlaubt { FIXED($value, digits: 2) } m/s. Schalten Sie auf Automatik, oder senken Sie limits.cartesian_speed_m_s.
kuka-other-commands = die Bewegung der Sunrise-Anwendung nimmt keine Gelenkstellungen (Kommandomodus { $mode }, Überlagerung { $overlay }; Heft braucht 1 und 1). Nehmen Sie FRIJointOverlay mit ClientCommandMode.POSITION (JOINT_POSITION in FRI 2).
kuka-other-control = die Sunrise-Anwendung bewegt in einer anderen Regelungsart ({ $mode }; Heft braucht 0, Positionsregelung). Beginnen Sie die Bewegung mit PositionControlMode: In Impedanzregelung gibt der Arm seiner Last nach.
kuka-line-too-slow = die Verbindung zum Roboter an { $host } ist binnen { FIXED($limit_s, digits: 0) } s nicht gut genug geworden (Güte { $quality } von 3, 2 nötig); nichts hat sich bewegt. Nehmen Sie ein eigenes Kabel und einen Rechner ohne andere Arbeit, oder eine längere Sendeperiode.
kuka-no-motion-yet = die Sunrise-Anwendung des Roboters an { $host } hat binnen { FIXED($limit_s, digits: 0) } s keine Bewegung begonnen, die Heft führen könnte; nichts hat sich bewegt. Sehen Sie am smartPAD nach, worauf sie wartet: Sie muss ein positionHold mit FRIJointOverlay beginnen, sobald die Verbindung gut ist.
kuka-not-begun = der Roboter an { $host } hat Hefts Befehle binnen { FIXED($limit_s, digits: 0) } s nicht übernommen; nichts hat sich bewegt. Suchen Sie eine Meldung auf dem smartPAD.
kuka-closed-yet = der Roboter an { $host } hat die Sitzung geschlossen; nichts hat sich bewegt. Starten Sie die Sunrise-Anwendung neu.
kuka-commanded-already = der Roboter an { $host } ist noch in einer Bewegung, die jemand führt; nichts hat sich bewegt. Beenden Sie jenes Programm, und beginnen Sie neu.
kuka-link-lost = keine Nachricht vom Roboter an { $host } seit { MILLI($value) } ms; seine Steuerung beendet die Bewegung selbst. Prüfen Sie die Leitung zwischen diesem Rechner und der Steuerung, und ob die Sunrise-Anwendung noch läuft, und beginnen Sie neu.
kuka-starved = dem Roboter wurde { MILLI($value) } ms lang nichts geschickt (Grenze { MILLI($limit) } ms), während er sich bewegte; er wurde angehalten. Dieser Rechner war zu beschäftigt, oder die Leitung war spät. Beginnen Sie neu.
kuka-unheard = die Steuerung hat seit { MILLI($value) } ms keinen Befehl bekommen (Grenze { MILLI($limit) } ms), obwohl ihre Nachrichten ankommen; der Roboter wurde angehalten. Prüfen Sie die Leitung, und dass nichts dazwischen nur eine Richtung durchlässt.
kuka-quality = die Steuerung findet die Verbindung zu schlecht (Güte { $value } von 3, { $limit } nötig) und lässt niemanden befehlen; der Roboter wurde angehalten. Nehmen Sie ein eigenes Kabel und einen Rechner ohne andere Arbeit, oder eine längere Sendeperiode. Beginnen Sie neu.
kuka-stop-0 = die Sicherheitssteuerung hat den Roboter sofort angehalten: ein Not-Halt, der Zustimmschalter, ein Schutzfeld oder eine Grenze. Sehen Sie am smartPAD, wodurch, und beginnen Sie neu.
kuka-stop-1 = die Sicherheitssteuerung hat den Roboter auf seiner Bahn angehalten: ein Schutzfeld, eine Tür oder eine Grenze. Sehen Sie am smartPAD, wodurch, und beginnen Sie neu.
kuka-stop-2 = die Sicherheitssteuerung verlangt Stillstand: ein Schutzfeld, eine Tür oder eine Grenze. Sehen Sie am smartPAD, wodurch, und beginnen Sie neu.
kuka-closed = die Steuerung hat die Sitzung geschlossen: Die Sunrise-Anwendung ist zu Ende. Sehen Sie am smartPAD, warum, starten Sie sie, und beginnen Sie neu.
kuka-ended = die Bewegung, die Heft führte, ist zu Ende (Sitzungszustand { $value }, { $limit } nötig): Die Sunrise-Anwendung wurde angehalten oder beendet, oder die Steuerung hat einen Befehl abgelehnt. Sehen Sie am smartPAD nach, und beginnen Sie neu.
kuka-operation = jemand hat am smartPAD die Betriebsart gewechselt (T1, T2, Automatik); der Roboter wurde angehalten. Beginnen Sie neu.
kuka-drives = der Antrieb der Achse A{ $axis } ist aus oder geht aus (Zustand { $value }, { $limit } nötig); der Roboter wurde angehalten. Sehen Sie am smartPAD, warum, und beginnen Sie neu.
kuka-control = jemand hat die Regelungsart gewechselt (auf { $value }; Heft braucht { $limit }, Positionsregelung); der Roboter wurde angehalten. Beginnen Sie neu.
kuka-counted = die Leitung des Roboters: { $missed } Nachrichten nicht gesehen, Güte im schlechtesten Fall { $quality } von 3.
kuka-external = bevor sich etwas bewegte, konnte die Steuerung { FIXED($torque, digits: 1) } N m an Gelenk { $joint } nicht erklären: ihre Lastdaten, oder etwas berührt den Arm.
