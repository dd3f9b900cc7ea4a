# Identifikation aus den Gelenkmomenten, ohne Sensor am Handgelenk.
torques-no-payload-seen = Keine Nutzlast zu sehen: Ihre Masse wäre { SIGNIFICANT($mass_kg, digits: 2) } kg (±{ SIGNIFICANT($half_width_kg, digits: 2) } kg, 95 %), was mit keiner vereinbar ist.
torques-no-payload = keine Nutzlast zu sehen, also nichts, dessen Trägheit bestimmt werden könnte
torques-mass-uncertain = die Momente bestimmen sie nur auf eine Standardunsicherheit von { SIGNIFICANT($std_kg, digits: 2) } kg bei { SIGNIFICANT($scale_kg, digits: 2) } kg, der Größe, auf die es ankommt
torques-first-moment-uncertain = die Momente bestimmen das erste Moment um { $axis } nur auf eine Standardunsicherheit von { SIGNIFICANT($std_kg_m, digits: 2) } kg m bei { SIGNIFICANT($scale_kg_m, digits: 2) } kg m, der Größe, auf die es ankommt
# Warum gar nichts bestimmt ist.
torques-no-torques = die Aufzeichnung hat weder eine Kraftmessung eines Sensors am Handgelenk noch Gelenkmomente
torques-no-joints = die Aufzeichnung hat Gelenkmomente, aber keine Gelenkstellungen oder keinen Roboter, zu dem sie gehören
torques-arm-unknown = das URDF nennt keine Masse für das, was sich mit { $joints } bewegt; der Anteil des Arms an den Momenten ist also unbekannt; an seine Stelle tritt eine Aufzeichnung ohne Nutzlast (--without)
torques-too-short = die Aufzeichnung ist zu kurz, zu langsam abgetastet (mindestens 20 Hz) oder voller Lücken
torques-nothing-turns = kein Gelenk dreht sich weit genug in eine Richtung (0,01 rad, schneller als 0,02 rad/s), um seine Reibung von der Last zu trennen
torques-other-scale = die Momente sind das { SIGNIFICANT($scale, digits: 2) }fache dessen, was die Bewegung des Arms nach seinem URDF verlangt: Es können Ströme sein, Momente vor dem Getriebe, mit anderem Vorzeichen oder eines anderen Arms; tau_* sind N m am Gelenk, positiv, wo sie das Gelenk vorwärts treiben
torques-needed = eine Nutzlast ohne Sensor am Handgelenk braucht Gelenkstellungen und -momente, ein URDF mit Massen oder eine Aufzeichnung desselben Arms ohne die Nutzlast (--without), und Gelenke, die sich drehen
torques-of-empty = --without
torques-none-in-empty =
    .found = keine Gelenkstellungen oder keine Gelenkmomente darin
    .expected = eine Aufzeichnung desselben Arms ohne die Nutzlast, mit beidem
# Was man wissen sollte, bevor man die Zahlen verwendet.
torques-arm-by-urdf = der Anteil des Arms an den Momenten ist dem URDF mit seiner Unsicherheit entnommen; eine Aufzeichnung desselben Arms ohne die Nutzlast (--without) macht die Antwort um ein Mehrfaches genauer
torques-arm-off = der Arm weicht von seinem URDF um das { SIGNIFICANT($times, digits: 2) }fache dessen ab, was darüber angegeben oder angenommen ist (link_mass_std); seine Unsicherheit wurde entsprechend vergrößert
torques-joints-idle = fast nichts war zu verwenden von { $joints }: kaum in eine Richtung gedreht, sodass die Reibung dort die Last verdeckt
torques-gain-off = das Moment von { $joint } weicht um { PERCENT($share) } % von dem ab, was die Bewegung des Arms verlangt: Seine Motorkonstante, seine Übersetzung oder seine Einheit kann falsch sein
torques-outlying = { PERCENT($share) } % der Fenster passen zu keinem Modell von Arm, Nutzlast und Reibung und zählen weniger: Berührungen oder Reibung anderer Art
torques-late = die Momente kommen { MILLI($late_s, digits: 1) } ms (±{ MILLI($half_width_s, digits: 1) } ms, 95 %) nach den Stellungen; berücksichtigt
# Das Unsicherheitsbudget.
torques-source-gain = Momentverstärkungen
torques-source-arm = Modell des Arms
torques-assumed-gain = die Unsicherheit der Momente ist nicht angegeben: 8 % für jedes Gelenk und 6 % für alle zusammen sind angenommen (torque_gain_std unter robot eintragen)
torques-assumed-arm = die Unsicherheit der Massen im URDF ist nicht angegeben: 10 % jeder Masse, 2 cm jedes Schwerpunkts und 20 % jedes Trägheitsmoments sind angenommen (link_mass_std unter robot eintragen)
torques-run-not-empty = Lauf { $run }: ist keiner ohne Last in der Zelle { $cell }; einen nennen, der mit empty beauftragt war
torques-not-together = Auftrag: { $key } geht nicht zusammen mit { $option }; Gelenkmomente zeigen die Last aus ganzen Läufen, verglichen wird der mit ihr
torques-without-beside =
    .found = eine Aufzeichnung ohne Last neben { $option }
    .expected = eines von beiden: verglichen wird sie mit einer, die die Last hat, wenn der Roboter durch ist
