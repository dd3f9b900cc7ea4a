cell-no-toml =
    .found = TOML, das sich nicht lesen lässt ({ $reason })
    .expected = TOML
cell-unknown-key =
    .found = ein unbekannter Schlüssel
    .expected = „{ $close }“, falls das gemeint war
cell-shape-without-kind =
    .found = kein solcher Schlüssel
    .expected = box, sphere, capsule oder cylinder
cell-unknown-shape =
    .found = „{ $kind }“
    .expected = box, sphere, capsule oder cylinder
cell-unknown-driver =
    .found = '{ $driver }'
    .expected = eines von { $drivers }

cell-argument = Zelle
cell-nearly-named =
    .found = „{ $name }“
    .expected = „{ $close }“, falls das gemeint war
cell-unknown =
    .found = „{ $name }“
    .expected = eine von { $known }, oder ein Ordner mit { $file }

cell-name-twice =
    .found = der Name „{ $name }“ { $count }-mal
    .expected = jeder Name einmal
cell-gravity-strength =
    .found = ({ $gravity_m_s2 }) m/s², { FIXED($strength_m_s2, digits: 3) } m/s² stark
    .expected = die der Erde, { FIXED($least_m_s2, digits: 1) } bis { FIXED($most_m_s2, digits: 1) } m/s²
cell-gravity-tilted =
    .found = ({ $gravity_m_s2 }) m/s², { DEGREES($angle_rad, digits: 0) } Grad von senkrecht nach unten
    .expected = höchstens { DEGREES($most_rad, digits: 0) } Grad: z der Welt zeigt nach oben, ein Roboter an Wand oder Decke wird durch robot.base gedreht
cell-floor-above-base =
    .found = { SIGNIFICANT($floor_z_m, digits: 6) } m, über der Basis des Roboters bei { SIGNIFICANT($base_z_m, digits: 6) } m
    .expected = ein Boden unter der Basis
cell-floor-too-deep =
    .found = { SIGNIFICANT($floor_z_m, digits: 6) } m, { FIXED($depth_m, digits: 1) } m unter der Basis des Roboters
    .expected = ein Boden höchstens { FIXED($most_m, digits: 0) } m unter der Basis
cell-box-too-large =
    .found = eine Ecke { FIXED($distance_m, digits: 2) } m vom Sensor entfernt
    .expected = keine weiter als { FIXED($most_m, digits: 0) } m
cell-base-inside =
    .found = die Basis des Roboters { FIXED($depth_m, digits: 3) } m darin
    .expected = die Basis außerhalb (höchstens { FIXED($most_m, digits: 3) } m darin)
cell-sensor-coarse =
    .found = { SIGNIFICANT($figure, digits: 6) }
    .expected = weniger als ein Zehntel von sensor.range, { SIGNIFICANT($range, digits: 6) }
cell-sensor-force-too-weak =
    .found = { SIGNIFICANT($range_n, digits: 6) } N für { $axis }
    .expected = mehr, als das Gewicht von { $carried } darauf bringt, { SIGNIFICANT($load_n, digits: 3) } N
cell-sensor-torque-too-weak =
    .found = { SIGNIFICANT($range_n_m, digits: 6) } N m für { $axis }
    .expected = mehr, als das Gewicht von { $carried } darauf bringt, { SIGNIFICANT($load_n_m, digits: 3) } N m

cell-payload-inertia =
    .found = mass { SIGNIFICANT($mass_kg, digits: 6) }, first_moment ({ $first_moment_kg_m }), inertia ({ $inertia_kg_m2 })
    .expected = Werte, die ein starrer Körper haben kann (Pseudo-Trägheit positiv definit)
cell-payload-too-heavy =
    .found = { SIGNIFICANT($mass_kg, digits: 6) } kg
    .expected = höchstens payload_limit_kg des Roboters, { SIGNIFICANT($most_kg, digits: 6) } kg
cell-payload-outside-box =
    .found = ein Schwerpunkt bei ({ $com_m }) m, { FIXED($distance_m, digits: 3) } m außerhalb des Quaders
    .expected = ein Quader, der die Last enthält

cell-no-such-link =
    .found = „{ $link }“
    .expected = ein Glied von { $urdf }: { $links }
cell-no-visual-shape =
    .found = „{ $link }“
    .expected =
        ein Glied von { $urdf } mit <visual> und ohne <collision>, { $count ->
            [0] von denen es keines gibt
           *[other] eines von { $links }
        }
cell-not-one-for-each-joint =
    .found =
        { $count ->
            [one] { $count } Wert
           *[other] { $count } Werte
        }
    .expected = { $joint_count }, für { $joints }
cell-home-outside-limits =
    .found = { SIGNIFICANT($home_rad, digits: 6) } für „{ $joint }“
    .expected = eine Stellung zwischen { SIGNIFICANT($lower_rad, digits: 6) } und { SIGNIFICANT($upper_rad, digits: 6) } rad
cell-velocity-too-high =
    .found = { SIGNIFICANT($velocity_rad_s, digits: 6) } für „{ $joint }“
    .expected = höchstens die { SIGNIFICANT($most_rad_s, digits: 6) } rad/s der URDF
