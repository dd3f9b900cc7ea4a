description-too-long =
    .found = { $characters } Zeichen
    .expected = höchstens { $most }
description-declaration =
    .found = die Deklaration { $declaration }
    .expected = eine URDF ohne Dokumenttypen und Entitäten
description-no-xml =
    .found = XML, das sich nicht lesen lässt ({ $reason })
    .expected = eine URDF
description-of-no-robot =
    .found = das Element <{ $tag }>
    .expected = <robot>
description-robot-without-name =
    .found = <robot> ohne Namen
    .expected = ein Name
description-too-deep =
    .found = Elemente, mehr als { $most }-fach verschachtelt
    .expected = eine URDF
description-incomplete =
    .found = das Element <{ $tag }>
    .expected = eine URDF, die in sich vollständig ist (xacro ausgeführt, nichts eingebunden)

description-no-value =
    .found = kein Wert
    .expected =
        { $count ->
            [1] eine endliche Zahl
           *[other] { $count } endliche Zahlen
        }
description-no-number =
    .found = „{ $text }“
    .expected =
        { $count ->
            [1] eine endliche Zahl
           *[other] { $count } endliche Zahlen
        }
description-too-far =
    .found = „{ $text }“
    .expected = ein Wert, der in einer Roboterzelle vorkommen kann, in SI-Einheiten

description-no-shape =
    .found = keine Form
    .expected = eines von { $kinds }
description-unknown-shape =
    .found = { $shapes }
    .expected = eines von { $kinds }
description-size-not-positive =
    .found = „{ $sizes }“
    .expected = positive Abmessungen
description-mesh-without-file =
    .found = kein Dateiname
    .expected = eine Datei
description-mesh-elsewhere =
    .found = „{ $name }“
    .expected = ein Pfad von der URDF aus, in ihrem Ordner
description-link-only-looks =
    .found = ein Glied, das sich bewegt und keine Form für Zusammenstöße hat
    .expected = <collision>, oder „{ $link }“ in robot.visual_shapes von cell.toml, wo sein Aussehen gelten soll
description-link-without-shape =
    .found = ein Glied, das sich bewegt und keine Form für Zusammenstöße hat
    .expected = <collision>, oder weder Masse noch Form, wo es nur ein Koordinatensystem ist

description-without-mass =
    .found = keine Masse
    .expected = Masse und Trägheit
description-without-inertia =
    .found = keine Trägheit
    .expected = Masse und Trägheit
description-negative-mass =
    .found = { SIGNIFICANT($mass_kg, digits: 6) } kg
    .expected = eine Masse, die nicht negativ ist
description-negative-moment =
    .found = ein negatives Moment unter ixx, iyy, izz = { SIGNIFICANT($ixx_kg_m2, digits: 6) }; { SIGNIFICANT($iyy_kg_m2, digits: 6) }; { SIGNIFICANT($izz_kg_m2, digits: 6) }
    .expected = keines
description-without-inertial =
    .found = kein Element <inertial>
    .expected = Masse und Trägheit eines Gliedes, das sich bewegt
description-massless =
    .found = { SIGNIFICANT($mass_kg, digits: 6) } kg
    .expected = eine positive Masse eines Gliedes, das sich bewegt
description-inertia-not-definite =
    .found = ein Hauptträgheitsmoment von { SIGNIFICANT($moment_kg_m2, digits: 3) } kg m²
    .expected = eine positiv definite Trägheit
description-inertia-of-none =
    .found = Hauptträgheitsmomente { SIGNIFICANT($least_kg_m2, digits: 4) }; { SIGNIFICANT($middle_kg_m2, digits: 4) }; { SIGNIFICANT($most_kg_m2, digits: 4) } kg m²
    .expected = keines größer als die Summe der anderen beiden

description-unknown-joint-type =
    .found = „{ $type }“
    .expected = eines von { $types }
description-joint-without-link =
    .found = kein Glied
    .expected = der Name eines Gliedes
description-unknown-link =
    .found = „{ $link }“
    .expected = ein Glied der URDF
description-joint-without-limits =
    .found = ein Gelenk ohne Grenzen (continuous)
    .expected = ein Drehgelenk mit Grenzen lower, upper und velocity
description-joint-mimics =
    .found = ein Gelenk, das einem anderen folgt (mimic)
    .expected = ein eigenes Drehgelenk
description-joint-not-revolute =
    .found = die Art „{ $type }“
    .expected = ein eigenes Drehgelenk
description-axis =
    .found = ({ $axis })
    .expected = eine Richtung
description-limit-missing =
    .found = kein { $key }
    .expected = die Grenzen { $keys }
description-limits =
    .found = lower { SIGNIFICANT($lower_rad, digits: 6) }, upper { SIGNIFICANT($upper_rad, digits: 6) }
    .expected = lower < upper, innerhalb ±{ FIXED($most_rad, digits: 2) } rad
description-velocity =
    .found = velocity { SIGNIFICANT($velocity_rad_s, digits: 6) }
    .expected = eine positive Geschwindigkeit in rad/s

description-name-twice =
    .found = { $count } dieses Namens
    .expected = eines
description-nameless =
    .found = eines ohne Namen
    .expected = ein Name
description-too-many-links =
    .found = { $links } Glieder
    .expected = höchstens { $most }
description-carried-twice =
    .found = { $count } Gelenke, die es tragen
    .expected = eines
description-several-roots =
    .found = die Wurzeln { $roots }
    .expected = ein Baum mit einem Glied als Wurzel
description-all-a-cycle =
    .found = ein Kreis von Gelenken
    .expected = ein Baum mit einem Glied als Wurzel
description-without-links =
    .found = kein Glied
    .expected = ein Baum mit einem Glied als Wurzel
description-link-in-cycle =
    .found = ein Kreis von Gelenken
    .expected = eine Kette vom Wurzelglied „{ $root }“ aus

description-frame = { $file }: Koordinatensystem
description-named-frame = { $file }: Koordinatensystem „{ $frame }“
description-unknown-frame =
    .found = „{ $frame }“
    .expected = eines der Glieder { $links }
description-no-chain =
    .found = keine Kette von Gelenken von „{ $base }“ dorthin
    .expected = eine
description-no-moving-joint =
    .found = kein bewegliches Gelenk zwischen „{ $base }“ und ihm
    .expected = mindestens eines
