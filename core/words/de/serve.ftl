serve-data-in-use =
    .found = ein Dienst, der schon darauf läuft
    .expected = ein eigener Ordner (--data DIR)
serve-no-store =
    .found = kein { $file }
    .expected = der Datenordner eines Dienstes (--data DIR)

# Was liest, wer den Dienst startet.
serve-started = Heft { $version }, Daten in { $folder }
serve-first-account = Erstes Konto: { $account }, Passwort { $password }
serve-open-once = Öffnen Sie diese Adresse einmal; dort wählen Sie ein eigenes Passwort:
