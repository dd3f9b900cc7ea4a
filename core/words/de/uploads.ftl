# Wo etwas ist in dem, was gesendet wurde.
uploads-upload = hochgeladene Datei
uploads-file = hochgeladene Datei: „{ $name }“

# Die ZIP-Datei.
uploads-no-zip = Content-Type: gefunden: „{ $found }“, erwartet: application/zip; senden Sie eine ZIP-Datei des Ordners { $what ->
        [cell] der Zelle
        [robot] des Roboters
        [log] des Logs
       *[recording] der Aufzeichnung
    }
uploads-not-unpackable =
    .found = eine ZIP-Datei, die sich nicht entpacken lässt ({ $reason })
    .expected = eine einfache ZIP-Datei des Ordners { $what ->
        [cell] einer Zelle
        [robot] eines Roboters
        [log] eines Logs
       *[recording] einer Aufzeichnung
    }
uploads-too-many-files =
    .found = { $files } Dateien
    .expected = höchstens { $most_files }
uploads-too-many-bytes =
    .found = { $unpacked_bytes } Byte, wenn entpackt
    .expected = höchstens { $most_bytes }
uploads-recording-too-large =
    .found = mehr als { $most_bytes } Byte, wenn entpackt
    .expected = eine Aufzeichnung von üblicher Größe
uploads-longer-than-listed =
    .found = mehr Byte, als die ZIP-Datei angibt
    .expected = { $listed_bytes }
uploads-symbolic-link =
    .found = eine symbolische Verknüpfung
    .expected = gewöhnliche Dateien
uploads-special-file =
    .found = eine besondere Datei
    .expected = gewöhnliche Dateien
uploads-encrypted-file =
    .found = eine verschlüsselte Datei
    .expected = gewöhnliche Dateien
uploads-compression-unknown =
    .found = das Packverfahren { $compression }
    .expected = ungepackte oder mit Deflate gepackte Dateien
uploads-name-outside =
    .found = ein Name, der hinausführt
    .expected = ein relativer Pfad ohne `..`, mit Schrägstrichen nach vorn
uploads-name-unusual =
    .found = dieser Name
    .expected = Buchstaben, Ziffern, `_`, `-` und `.`, in höchstens { $levels } Ebenen
uploads-kind-unknown =
    .found = eine Datei der Art „{ $kind }“
    .expected = eines von { $kinds }
uploads-same-names =
    .found = { $files } Dateien dieses Namens, ohne Rücksicht auf Groß- und Kleinschreibung
    .expected = eine
uploads-two-recordings =
    .found = zwei Dateien dieses Namens
    .expected = eine Aufzeichnung
uploads-no-cell-file =
    .found = kein { $file } zuoberst oder in dem einen Ordner
    .expected = { $file } und die Dateien, die es nennt
uploads-no-manifest =
    .found = kein { $file }
    .expected = der Ordner einer Aufzeichnung

# Die Prüfung einer hochgeladenen Zelle.
uploads-check-too-large =
    .found = mehr, als sich prüfen lässt ({ $reason })
    .expected = eine Zelle von üblicher Größe
uploads-check-too-slow =
    .found = mehr, als sich in { SIGNIFICANT($limit_s) } s prüfen lässt
    .expected = eine Zelle von üblicher Größe
uploads-check-broken-off =
    .found = etwas, woran die Prüfung endete (zu wenig Speicher, oder ein Netz, das sich nicht lesen lässt)
    .expected = eine Zelle von üblicher Größe
uploads-model-not-buildable =
    .found = ein Modell, das sich nicht bauen lässt ({ $reason })
    .expected = Glieder und Netze, mit denen es geht
uploads-outside-file =
    .found = eine Datei außerhalb des hochgeladenen Ordners
    .expected = Dateien darin
uploads-program =
    .found = ein Versuch von { $event }
    .expected = eine Zelle, die nur aus Daten besteht
uploads-checker-ended = hochgeladene Datei: die Prüfung endete unerwartet; nichts wurde geändert, senden Sie sie noch einmal
uploads-other-cell = hochgeladene Datei: die Zelle nennt sich „{ $cell }“, nicht „{ $name }“; senden Sie sie an /api/cells/{ $cell }
uploads-cell-exists = die Zelle „{ $cell }“ gibt es schon; PUT /api/cells/{ $cell } ersetzt sie

# Die Ordner der Zellen.
uploads-cell-misnamed =
    .found = „{ $name }“
    .expected = der Name ihres Ordners, „{ $folder }“
