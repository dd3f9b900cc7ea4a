cli-folder-missing =
    .found = ein Ordner, den es nicht gibt
    .expected = eine Datei in einem Ordner, den es gibt
cli-exists-already =
    .found = etwas, das es schon gibt
    .expected = ein neuer Name oder ein leerer Ordner
cli-kept-already =
    .found = etwas, das es schon gibt
    .expected = ein neuer Ordner für --keep
cli-no-such-payload =
    .found = „{ $name }“
    .expected = eine von { $names }
cli-no-payloads =
    .found = „{ $name }“
    .expected = eine Last der Zelle, die keine hat; fügen Sie eine in cell.toml hinzu
cli-experiment-without-cell =
    .found = keine Zelle, in der es geplant wird
    .expected = daneben --cell CELL
cli-experiment-beside-others =
    .found = daneben --from, --axes oder --holds-only
    .expected = keines davon: das Experiment hat seine eigene Bewegung, von der Grundstellung aus
cli-experiment-of-another-cell =
    .found = „{ $found }“
    .expected = „{ $cell }“, die Zelle, die es ausführen soll
cli-experiment-without-motion =
    .found = keine
    .expected = eine Bewegung; verlangt ist { $motion }
cli-not-seeds =
    .found = „{ $found }“
    .expected = Startwerte wie 300,305,400-420
cli-not-xacro-argument =
    .found = „{ $found }“
    .expected = NAME:=WERT
cli-result-unreadable =
    .found = nichts, was sich lesen lässt ({ $reason })
    .expected = eine Datei, die --json geschrieben hat
cli-no-result =
    .found = etwas anderes
    .expected = die Antwort von `heft run` oder `heft identify`
cli-no-diagnosis =
    .found = etwas anderes
    .expected = die Antwort von `heft diagnose`
cli-twin-nominal =
    .found = „{ $effect }“
    .expected = nichts: der Zwilling ist der nominelle
cli-effect-of-twin = Zwilling von { $cell }: Effekt
cli-error = heft: { $error }
cli-interrupted = heft: unterbrochen; nichts bewegte sich.
cli-planning = plant
cli-estimating = schätzt
cli-fitting = passt Effekte an
cli-trials = Versuche
cli-cell = Zelle
cli-title = Titel
cli-axes = Achsen
cli-obstacles = Hindernisse
cli-zones = Schutzzonen
cli-payloads = Lasten
cli-cell-unusable = { $name } ist nicht brauchbar: { $flaw }
cli-cell-made = { $folder } ist angelegt; die Grundstellung ist abgebildet in { $picture }.
cli-cell-next = Als Nächstes: Sehen Sie cell.toml an, tragen Sie ein, was dort steht, dann `heft cell check { $cell }` und `heft plan { $cell }`.
cli-cell-counts = { $name }: { $wrong ->
        [0] nichts
       *[other] { $wrong }
    } falsch, { $doubtful ->
        [0] nichts
       *[other] { $doubtful }
    } zweifelhaft.
cli-one-of-please = Bitte eines von { $possible }.
cli-twin-added = { $effect } in den Zwilling von { $cell } aufgenommen.
cli-twin-replaced = { $effect } im Zwilling von { $cell } durch die neue Anpassung ersetzt.
cli-twin-removed = { $effect } aus dem Zwilling von { $cell } entfernt.
cli-twin-empty = Der Zwilling von { $cell } ist der nominelle: nichts wurde ihm hinzugefügt.
cli-twin-title = Zwilling von { $cell }
cli-twin-caption = ± ist die Standardunsicherheit; die Abweichung zählt in Einheiten des Rauschens
cli-twin-gap = Abweichung vorher, nachher
cli-twin-recording = Aufzeichnung
cli-twin-entered = aufgenommen
cli-trial-sealed = Versuch { $seed }: versiegelt { $hash }
cli-trial-answered = Versuch { $seed }: verborgen { $planted }, Größe { FIXED($size, digits: 2) }; Antwort { $answer }: { $mark }
cli-export-target = { $title }: { $says }
cli-export-frame = In: { $frame }; { $says }.
cli-export-lack = { $target } hat keinen Platz für { $name } = { SIGNIFICANT($lost, digits: 3) } { $unit }, das { FIXED($times, digits: 1) }-fache seiner Unsicherheit.
cli-nothing-to-settle = Es gibt nichts zu klären: { $file } wird nicht geschrieben.
cli-report = Bericht: { $file }
