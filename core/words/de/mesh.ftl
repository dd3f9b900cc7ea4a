mesh-scale-not-positive =
    .found = der Maßstab { $scale }
    .expected = positive Faktoren
mesh-file-empty =
    .found = eine leere Datei
    .expected = ein Netz
mesh-unknown-kind =
    .found = eine Datei der Art „{ $kind }“
    .expected = eine von { $kinds }
mesh-unreadable =
    .found = ein Netz, das sich nicht lesen lässt ({ $reason })
    .expected = eine heile STL-, OBJ- oder DAE-Datei
mesh-unreadable-for-second-opinion =
    .found = ein Netz, das die zweite Prüfung der Pläne nicht lesen kann ({ $reason })
    .expected = eine STL-, OBJ- oder DAE-Datei
mesh-empty =
    .found = kein Dreieck
    .expected = ein Netz mit Dreiecken
mesh-not-finite =
    .found = eine Ecke, die keine Zahl ist (NaN oder unendlich)
    .expected = endliche Koordinaten
mesh-too-large =
    .found = eine Ecke { SIGNIFICANT($distance_m, digits: 4) } m vom Ursprung
    .expected = höchstens { SIGNIFICANT($most_m, digits: 3) } m; Millimeter haben den Maßstab 0.001
mesh-too-many-triangles =
    .found = { $triangles } Dreiecke
    .expected = höchstens { $most }
mesh-no-such-vertex =
    .found = eine Fläche aus Ecken, die es nicht gibt
    .expected = Nummern seiner { $vertices } Ecken
mesh-flat =
    .found = { $vertices ->
        [one] { $vertices } Ecke
       *[other] { $vertices } Ecken
    } in einer Ebene, { SIGNIFICANT($x_m, digits: 3) } x { SIGNIFICANT($y_m, digits: 3) } x { SIGNIFICANT($z_m, digits: 3) } m
    .expected = ein Körper aus mindestens vier Ecken, die nicht in einer Ebene liegen
mesh-incomplete-triangle =
    .found = { $vertices ->
        [one] { $vertices } Ecke
       *[other] { $vertices } Ecken
    }
    .expected = drei für jedes Dreieck einer ASCII-STL-Datei
mesh-stl-breaks-off =
    .found = eine STL-Datei, die nach { $bytes } Byte abbricht
    .expected = 84 Byte und 50 für jedes ihrer Dreiecke
mesh-dae-dead-link =
    .found = ein Verweis auf „{ $name }“, das es nicht gibt
    .expected = eine DAE-Datei, die in sich vollständig ist
mesh-dae-too-deep =
    .found = Knoten, die mehr als { $most }-fach verschachtelt sind
    .expected = eine Szene ohne Ringe
mesh-dae-too-many-elements =
    .found = mehr als { $most } Elemente in ihrer Szene
    .expected = eine Szene aus weniger
mesh-dae-declaration =
    .found = die Deklaration { $declaration }
    .expected = eine DAE-Datei ohne Dokumenttypen und Entitäten
mesh-dae-does-not-parse =
    .found = XML, das sich nicht lesen lässt ({ $reason })
    .expected = eine DAE-Datei
