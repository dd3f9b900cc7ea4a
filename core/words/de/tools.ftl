tools-named-like-obstacle =
    .found = der Name eines Hindernisses oder einer Zone
    .expected = ein eigener Name
tools-named-like-link =
    .found = der Name eines Glieds der URDF
    .expected = ein eigener Name
tools-named-like-payload =
    .found = der Name des Quaders der Last
    .expected = ein eigener Name

tools-value-beside-links =
    .found = ein Wert neben links
    .expected = Glieder der URDF (links) oder eigene Werte des Werkzeugs, nicht beides
tools-without-value =
    .found = kein solcher Schlüssel
    .expected = { $keys }, oder Glieder der URDF (links)
tools-links-massless =
    .found = Glieder ohne Masse
    .expected = Glieder, deren <inertial> in der URDF steht, oder { $keys }
tools-inertia =
    .found = mass { SIGNIFICANT($mass_kg, digits: 6) }, first_moment ({ $first_moment_kg_m }), inertia ({ $inertia_kg_m2 })
    .expected = Werte, die ein starrer Körper haben kann (Pseudo-Trägheit positiv definit)
tools-outside-box =
    .found = ein Schwerpunkt bei ({ $com_m }) m, { FIXED($distance_m, digits: 3) } m außerhalb des Quaders
    .expected = ein Quader, der das Werkzeug enthält
tools-too-heavy-for-joint =
    .found = { SIGNIFICANT($torque_n_m, digits: 4) } N m an „{ $joint }“ in der Grundstellung, mit den Gliedern
    .expected = Werkzeuge, die das Gelenk halten kann, { SIGNIFICANT($effort_n_m, digits: 4) } N m (limit effort der URDF)

tools-link-not-behind-sensor =
    .found = „{ $link }“
    .expected =
        Glieder hinter dem Sensorkoordinatensystem „{ $frame }“, { $count ->
            [0] von denen es keine gibt
           *[other] { $links }
        }
tools-link-twice =
    .found = „{ $link }“, das schon in tools.{ $tool } steht
    .expected = jedes Glied in einem Werkzeug, einmal
tools-links-of-none =
    .found = „{ $frame }“, hinter dem die Glieder { $links } hängen, die der Sensor spürt und die zu keinem Werkzeug gehören
    .expected = ein Werkzeug mit ihnen ([tools.NAME], das sie in links nennt) oder ein Sensorkoordinatensystem hinter ihnen
