newcell-wrong = falsch: { $flaw }.
newcell-doubtful = fraglich: { $doubt }.
newcell-no-model =
    .found = ein Modell, das sich nicht bauen lässt ({ $reason })
    .expected = Glieder und Netze, mit denen es geht
newcell-gravity-tilted =
    .found = ({ $gravity_m_s2 }) m/s², { DEGREES($angle_rad, digits: 0) } Grad von senkrecht nach unten
    .expected = senkrecht nach unten: Ein geneigter Roboter wird durch robot.base.rpy_rad gedreht, nicht durch die Schwerkraft
newcell-speed-high =
    .found = { SIGNIFICANT($speed_m_s, digits: 6) } m/s
    .expected = höchstens { SIGNIFICANT($most_m_s, digits: 6) } m/s, wo Menschen in der Nähe sind
newcell-acceleration-unusual =
    .found = { SIGNIFICANT($acceleration_rad_s2, digits: 6) } rad/s²
    .expected = was der Hersteller des Roboters angibt; üblich sind { SIGNIFICANT($least_rad_s2, digits: 6) } bis { SIGNIFICANT($most_rad_s2, digits: 6) } rad/s²
newcell-friction-unknown =
    .found = nichts
    .expected = was von den Antrieben bekannt ist; ohne das beurteilt eine Diagnose die Reibung nur nach dem Schleppfehler
newcell-zones-none =
    .found = keine
    .expected = ein [[zones]] für jeden Ort, an dem Menschen sein können; ohne eines wird nichts von ihnen ferngehalten
newcell-payloads-none =
    .found = keine
    .expected = ein [payloads.NAME], um einen Lauf zu simulieren oder das Ergebnis zu vergleichen; zum Planen braucht es keines
newcell-pair-unwatched =
    .found = „{ $first }“ und „{ $second }“ ausgelassen
    .expected = zwei Glieder, die sich nicht berühren können: Sehen Sie sie sich am Roboter an, ihren Abstand überwacht nichts
newcell-link-as-it-looks =
    .found = „{ $link }“, wie es aussieht
    .expected = eine Form für Zusammenstöße in der URDF, mit Kabeln und Abdeckungen, falls sie der sichtbaren fehlen
newcell-sensor-not-stated =
    .found = „{ $name }“
    .expected = Rauschen, Messbereich und Auflösung des Sensors, der da ist: Die Unsicherheiten hängen davon ab
newcell-mount-unknown =
    .found = nichts
    .expected = das Sensorkoordinatensystem im Flansch; ohne das wird eine Last nur im Sensorkoordinatensystem ausgegeben
newcell-sensor-small =
    .found = { SIGNIFICANT($range_n, digits: 6) } N für die { FIXED($weight_n, digits: 0) } N von „{ $payload }“
    .expected = ein Sensor mit Raum für das, was eine Bewegung hinzufügt
newcell-sensor-large =
    .found = { SIGNIFICANT($range_n, digits: 6) } N für die { SIGNIFICANT($weight_n, digits: 2) } N von „{ $payload }“
    .expected = ein feinerer Sensor: Seine Fehler wachsen mit seinem Messbereich
newcell-effort-none =
    .found = ein Drehmoment (effort) von { SIGNIFICANT($effort_n_m, digits: 6) } N m
    .expected = das größte Drehmoment des Gelenks: ohne das wird keines geprüft
newcell-effort-low =
    .found = ein Drehmoment (effort) von { SIGNIFICANT($effort_n_m, digits: 6) } N m, wo der gestreckte Arm mit seinen Werkzeugen { FIXED($needed_n_m, digits: 0) } N m verlangen kann
    .expected = das größte Drehmoment des Gelenks und die Massen der Glieder, wie der Hersteller sie angibt
newcell-floor-above-base =
    .found = { SIGNIFICANT($floor_z_m, digits: 6) } m, über dem tiefsten Punkt der Basis des Roboters bei { FIXED($base_z_m, digits: 3) } m
    .expected = die Höhe des Bodens
newcell-floor-far-below =
    .found = { FIXED($depth_m, digits: 1) } m unter der Basis des Roboters
    .expected = die Höhe des Bodens im Weltkoordinatensystem
newcell-zone-within-reach =
    .found = höchstens { FIXED($distance_m, digits: 2) } m von der Schulter eines Arms, der { FIXED($reach_m, digits: 2) } m weit reicht
    .expected = ein Schutz, der nicht von der Planung abhängt, wo immer Menschen darin sein können
newcell-box-off-flange =
    .found = ein Quader { FIXED($distance_m, digits: 3) } m vor dem Flansch
    .expected = ein Quader, der im Ursprung des Sensorkoordinatensystems beginnt: Auch was die Last hält, braucht Raum
newcell-box-long =
    .found = { SIGNIFICANT($length_m, digits: 6) } m lang, bei einem Arm von { FIXED($reach_m, digits: 2) } m
    .expected = die Größe dessen, was dort hängt: Es bleibt womöglich wenig Raum zum Bewegen
newcell-home-narrow =
    .found = „{ $first }“ { FIXED($distance_m, digits: 3) } m von „{ $second }“, wovon { FIXED($required_m, digits: 3) } m verlangt sind
    .expected = eine Grundstellung mit mehr Raum: Jeder Lauf beginnt und endet dort
newcell-shapes-overlap =
    .found = „{ $first }“ und „{ $second }“, deren Formen sich bei jedem Winkel der Gelenke dazwischen überschneiden, ausgelassen
    .expected = zwei Glieder, die sich am Roboter nicht treffen können: Sehen Sie sie sich an, und bessern Sie ihre Formen aus, falls sie es können

newcell-no-name =
    .found = „{ $name }“
    .expected = 1 bis 64 Buchstaben ohne Umlaute, Ziffern, - und _; wo der Ordner der Zelle entsteht, sagt --into DIR
newcell-two-sensor-frames =
    .found = sowohl --sensor-frame als auch --mount
    .expected = eines davon
newcell-exists =
    .found = etwas, das es schon gibt
    .expected = ein neuer Name
newcell-no-folder =
    .found = etwas, das kein Ordner ist
    .expected = ein Ordner
newcell-no-package-path =
    .found = kein solcher Ordner
    .expected = ein Ordner mit ROS-Paketen, oder ein Paket
newcell-not-written =
    .found = ein Ordner, in den nicht geschrieben werden kann ({ $reason })
    .expected = ein Datenträger mit Platz, und die Erlaubnis
newcell-joint-unknown =
    .found = ein Gelenk, das nicht zum Arm gehört
    .expected = eines von { $joints }
newcell-link-unmoved =
    .found = ein Glied, das kein Gelenk des Arms bewegt
    .expected = eines von { $links }
newcell-range-empty =
    .found = { SIGNIFICANT($lower_rad, digits: 4) } rad
    .expected = weniger als die obere Grenze, { SIGNIFICANT($upper_rad, digits: 4) } rad
newcell-no-such-link =
    .found = kein solches Glied in { $file }
    .expected = eines von { $links }

newcell-package = { $file }: Paket „{ $name }“
newcell-no-package-name =
    .found = kein Name eines Pakets
    .expected = Buchstaben ohne Umlaute, Ziffern, _, - und .
newcell-no-such-package =
    .found = kein solches Paket in { $folders } oder darüber
    .expected = ein Ordner dieses Namens; wo er ist, sagt --package-path DIR
newcell-mesh-address =
    .found = „{ $name }“
    .expected = package://, oder ein Pfad von der Beschreibung aus
newcell-mesh-outside =
    .found = „{ $name }“, was aus dem Ordner der Beschreibung hinausführt
    .expected = --package-path DIR für einen Ordner, der gelesen werden darf
newcell-no-mesh =
    .found = „{ $name }“
    .expected = ein Netz, eines von { $suffixes }
newcell-no-shapes =
    .found = keine Form an irgendeinem Glied, das sich bewegt
    .expected = Glieder mit Formen (collision oder visual)

newcell-link-name =
    .found = „{ $name }“
    .expected = ein Name aus höchstens { $most } druckbaren Zeichen
newcell-link-exists =
    .found = „{ $link }“ schon in der Beschreibung
    .expected = --sensor-frame { $link } statt --mount
newcell-no-turning-joint =
    .found = kein Gelenk, das sich dreht
    .expected = ein Arm aus Drehgelenken
newcell-sensor-on-no-arm =
    .found = kein bewegliches Gelenk darüber
    .expected = ein Sensorkoordinatensystem am Ende eines Arms
newcell-base-frame = { $file }: Basiskoordinatensystem „{ $base }“
newcell-base-apart =
    .found = keine Kette von Gelenken von ihm zu „{ $sensor }“
    .expected = ein Glied über dem Sensorkoordinatensystem
newcell-base-unmoved =
    .found = kein bewegliches Gelenk zwischen ihm und „{ $sensor }“
    .expected = ein Arm zwischen beiden
newcell-joint-of-no-arm =
    .found =
        ein Gelenk zwischen „{ $base }“ und „{ $sensor }“, { $mimics ->
            [true] das einem anderen folgt (mimic)
           *[false] von der Art { $type }
        }
    .expected = Gelenke, die sich drehen; --base-frame { $child } nimmt den Arm dahinter, --sensor-frame { $parent } den davor
newcell-behind-sensor = { $file }: Glieder hinter dem Sensorkoordinatensystem „{ $sensor }“
newcell-links-of-none =
    .found = { $links }
    .expected = --behind-sensor tool, wenn der Sensor sie trägt, --behind-sensor robot, wenn er hinter ihnen sitzt
newcell-what-is-behind = Hinter dem Sensorkoordinatensystem „{ $sensor }“ hängen { $links }. Trägt der Sensor sie (tool), oder sitzt er hinter ihnen (robot)?
newcell-home = { $file }: Grundstellung
newcell-no-home =
    .found = keine von { $count } Stellungen frei, meist wegen „{ $first }“ und „{ $second }“
    .expected = Formen, die dem Arm Raum lassen, oder Glieder hinter dem Sensorkoordinatensystem, die mit --behind-sensor angegeben sind

newcell-sensor-mounted = Das Sensorkoordinatensystem ist das neue Glied „{ $link }“, befestigt an „{ $mount }“.
newcell-sensor-named = Das Sensorkoordinatensystem ist „{ $link }“, das wie ein Kraft-Momenten-Sensor heißt; --sensor-frame LINK wählt ein anderes.
newcell-sensor-last = Das Sensorkoordinatensystem ist „{ $link }“, das letzte Glied der längsten Kette vor einer Hand; --sensor-frame LINK wählt ein anderes.
newcell-sensor-moved = Das Sensorkoordinatensystem ist von „{ $before }“ hinter das verlegt, was als Roboter zählt, nach „{ $sensor }“: { $links }.
newcell-felt-as-tool = Hinter dem Sensorkoordinatensystem „{ $sensor }“, vom Sensor als Werkzeug gespürt: { $links }.
newcell-beside-sensor = Vom letzten Gelenk getragen, aber nicht vom Sensor, und damit Teil des Roboters: { $links }.
newcell-base-chosen = Das Basiskoordinatensystem ist „{ $link }“, das das erste bewegliche Gelenk trägt; --base-frame LINK wählt ein anderes.

newcell-joint-fixed =
    Das Gelenk „{ $joint }“ ({ $type }{ $mimics ->
        [true] , folgt einem anderen
       *[false] {""}
    }) gehört nicht zum Arm: festgehalten bei { SIGNIFICANT($angle_rad, digits: 6) } rad.
newcell-slide-fixed =
    Das Gelenk „{ $joint }“ ({ $type }{ $mimics ->
        [true] , folgt einem anderen
       *[false] {""}
    }) gehört nicht zum Arm: festgehalten bei { SIGNIFICANT($place_m, digits: 6) } m.
newcell-endless-limited = Das Gelenk „{ $joint }“ dreht ohne Ende: begrenzt auf { SIGNIFICANT($lower_rad, digits: 4) } ... { SIGNIFICANT($upper_rad, digits: 4) } rad.
newcell-range-taken = Das Gelenk „{ $joint }“ hat keine Grenzen der Stellung: { SIGNIFICANT($lower_rad, digits: 4) } ... { SIGNIFICANT($upper_rad, digits: 4) } rad angenommen; setzen Sie die des Roboters ein.
newcell-velocity-taken = Das Gelenk „{ $joint }“ hat keine Grenze der Geschwindigkeit: { SIGNIFICANT($velocity_rad_s, digits: 6) } rad/s angenommen; setzen Sie die des Roboters ein.
newcell-effort-taken = Das Gelenk „{ $joint }“ hat keine Grenze des Drehmoments: { SIGNIFICANT($effort_n_m, digits: 6) } N m angenommen, { SIGNIFICANT($times, digits: 6) }-mal so viel, wie das Gewicht des Arms verlangen kann; setzen Sie die des Roboters ein.
newcell-accelerations-taken = Beschleunigungen von { $accelerations_rad_s2 } rad/s² angenommen: die größte Geschwindigkeit jedes Gelenks in { SIGNIFICANT($seconds_s, digits: 2) } s, zwischen { SIGNIFICANT($least_rad_s2, digits: 3) } und { SIGNIFICANT($most_rad_s2, digits: 3) } rad/s².
newcell-mass-taken = Das Glied „{ $link }“ hat keine Masse: { SIGNIFICANT($mass_kg, digits: 3) } kg nach seiner Form bei { FIXED($density_kg_m3, digits: 0) } kg/m³ angenommen; setzen Sie die des Roboters ein, Drehmomente und Simulation rechnen damit.
newcell-inertia-taken = Das Glied „{ $link }“ hat keine Trägheit, die ein Körper haben kann: die seiner Form mit seinen { SIGNIFICANT($mass_kg, digits: 3) } kg angenommen; setzen Sie die des Roboters ein, Drehmomente und Simulation rechnen damit.
newcell-visual-taken = Das Glied „{ $link }“ hat keine Form für Zusammenstöße: seine sichtbare Form ist genommen (robot.visual_shapes).
newcell-pair-left-out = „{ $first }“ und „{ $second }“ überschneiden sich in allen Stellungen, die angesehen wurden: ausgelassen (robot.adjacent).
newcell-pair-overlaps = Sie überschneiden sich, oder beinahe, in allen { $count } Stellungen des Arms, die angesehen wurden.
newcell-pair-declared = Von Ihnen ausgelassen; nichts spricht dafür, dass sie sich immer überschneiden.

newcell-floor-out-of-reach = Der Arm hängt unter seiner Basis: der Boden ist außer Reichweite gelegt, auf { SIGNIFICANT($floor_z_m, digits: 6) } m; setzen Sie seine Höhe ein.
newcell-box-without-home = Mit einem Hüllquader der Last von { SIGNIFICANT($width_m, digits: 6) } m Breite, { SIGNIFICANT($gap_m, digits: 6) } m vor dem Flansch, ist keine Grundstellung frei, meist wegen „{ $first }“ und „{ $second }“.
newcell-payload-box = Der Hüllquader der Last ist { SIGNIFICANT($x_m, digits: 6) } x { SIGNIFICANT($y_m, digits: 6) } x { SIGNIFICANT($z_m, digits: 6) } m groß, { SIGNIFICANT($gap_m, digits: 6) } m vor dem Flansch; tragen Sie in cell.toml ein, was wirklich dort hängt.
newcell-nearest-at-home = In der Grundstellung sind „{ $first }“ und „{ $second }“ sich am nächsten, { FIXED($distance_m, digits: 3) } m voneinander entfernt.
newcell-sensor-of-nobody = Rauschen, Messbereich und Auflösung des Sensors sind von keinem wirklichen Sensor: setzen Sie die des Ihren ein.

newcell-picture = { $name } in Grundstellung
newcell-picture-colours = Arm blau, Basis grau, Werkzeug grün, Raum der Last orange; Sensorachsen x rot, y grün, z blau
