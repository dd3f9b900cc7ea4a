# Die Wörter für Rollen, für andere Meldungen.
people-role = { $role ->
    [viewer] Betrachter
    [operator] Bediener
    [engineer] Ingenieur
    [mes] Leitsystem
    [admin] Verwalter
   *[other] { $role }
}

people-account-unknown = Konto: keines heißt „{ $account }“. Sehen Sie nach, welche es gibt, und versuchen Sie es noch einmal.
people-account-exists = das Konto „{ $account }“ gibt es schon; wählen Sie einen anderen Namen, oder ändern Sie jenes
people-last-admin = das Konto „{ $account }“ ist der letzte Verwalter, der sich anmelden kann; legen Sie erst einen anderen an
people-session-unknown = Sitzung: keine von Ihren heißt „{ $session }“. Sehen Sie nach, welche es gibt, und versuchen Sie es noch einmal.
people-key-unknown = Schlüssel: keiner heißt „{ $key }“. Sehen Sie nach, welche es gibt, und versuchen Sie es noch einmal.
people-key-exists = den Schlüssel „{ $key }“ gibt es schon; widerrufen Sie ihn, oder wählen Sie einen anderen Namen
people-role-not-for-machines = Rolle: gefunden: { people-role }, erwartet: eine von { $roles }: eine Maschine gibt keine Bewegung frei und legt keine Konten an

# Anmelden.
people-key-refused = Schlüssel: unbekannt, abgelaufen oder widerrufen; bitten Sie um einen neuen, wer die Konten führt
people-session-over = Sitzung: beendet oder abgelaufen; melden Sie sich neu an
people-sign-in-refused = Name oder Passwort: nicht richtig; versuchen Sie es noch einmal, oder fragen Sie, wer die Konten führt
people-sign-in-blocked = Anmeldung: zuletzt zu viele Fehlversuche; versuchen Sie es in { FIXED($retry_after_s, digits: 0) } s noch einmal
people-password-wrong = Passwort: nicht das bisherige
people-key-without-password = Passwort: ein Schlüssel hat keines; nur ein Konto ändert seines
people-not-signed-in = { $endpoint }: melden Sie sich an

# Wer was darf, und von wo aus.
people-endpoint-closed = { $endpoint }: steht nicht in der Tabelle der Rechte, also niemandem erlaubt
people-role-lacking = { $endpoint }: { PERSON($who) } ist { $roles }; nötig ist eines von { $needed }
people-without-role = { $endpoint }: { PERSON($who) } ist ohne Rolle; nötig ist eines von { $needed }
people-origin-foreign = Herkunft: „{ $origin }“ ist keine Seite dieses Dienstes; setzen Sie HEFT_ORIGINS, wenn sie eine sein soll
people-origin-missing = Herkunft: der Browser muss sagen, zu welcher Seite er gehört
people-csrf-token-wrong = { $header }: nicht das der Sitzung; laden Sie die Seite neu

# Das Protokoll dessen, was getan wurde.
people-audit-log = Audit-Protokoll
people-audit-unbroken = Audit-Protokoll: { $entries } Einträge, ununterbrochen; der letzte Hash ist { $hash }
people-audit-entry-missing =
    .found = Eintrag { $number } fehlt; der nächste ist { $next_number }
    .expected = eine ununterbrochene Kette; spielen Sie die Datenbank aus einer Sicherung zurück und finden Sie heraus, wer Zugriff auf sie hatte
people-audit-entry-unlinked =
    .found = Eintrag { $number } folgt nicht auf Eintrag { $last_number }: der Hash des Eintrags davor ist ein anderer
    .expected = eine ununterbrochene Kette; spielen Sie die Datenbank aus einer Sicherung zurück und finden Sie heraus, wer Zugriff auf sie hatte
people-audit-entry-changed =
    .found = Eintrag { $number } ({ $action }) wurde geändert: sein Hash passt nicht zu dem, was er sagt
    .expected = eine ununterbrochene Kette; spielen Sie die Datenbank aus einer Sicherung zurück und finden Sie heraus, wer Zugriff auf sie hatte
people-audit-hash-missing =
    .found = { $entries } Einträge, keiner mit dem Hash { $hash }
    .expected = dieser Eintrag; das Ende des Protokolls wurde abgeschnitten oder ersetzt
