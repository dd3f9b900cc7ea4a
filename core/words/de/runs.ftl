# Die Wörter für Befehle und Zustände eines Laufs, für andere Meldungen. Befehle heißen wie in der API, Zustände wie in PackML.
runs-command = { $command ->
    [hold] Anhalten
    [resume] Fortfahren
    [stop] Stoppen
    [abort] Abbrechen
    [clear] Quittieren
    [cancel] Stornieren
    [release] Freigeben
   *[other] { $command }
}
runs-state = { $state ->
    [Resetting] „Plant“
    [Idle] „Wartet auf Freigabe“
    [Starting] „Beginnt“
    [Execute] „Läuft“
    [Completing] „Wertet aus“
    [Complete] „Fertig“
    [Holding] „Hält an“
    [Held] „Angehalten“
    [Unholding] „Fährt fort“
    [Suspending] „Überwachung stoppt den Roboter“
    [Suspended] „Von der Überwachung gestoppt“
    [Unsuspending] „Fährt fort“
    [Stopping] „Stoppt“
    [Stopped] „Gestoppt“
    [Aborting] „Bricht ab“
    [Aborted] „Abgebrochen“
    [Clearing] „Wird quittiert“
   *[other] { $state }
}

# Warum ein Lauf nicht durchkam, oder warum er steht.
runs-command-asked =
    { $command ->
        [stop] gestoppt von { PERSON($who) }.
        [abort] abgebrochen von { PERSON($who) }.
       *[other] { runs-command } von { PERSON($who) }.
    }
runs-stopped-by-nobody = gestoppt von jemandem, der nicht angemeldet war, Adresse { $address }.
runs-cancelled = storniert von { PERSON($who) }.
runs-cancelled-because = storniert von { PERSON($who) }: { $why }
runs-ended = der Lauf wurde beendet.
runs-shut-down = der Dienst wurde beendet; der Roboter wurde gestoppt.
runs-service-ended = der Dienst endete, während der Lauf im Zustand { runs-state } war; der Roboter wurde gestoppt. Prüfen Sie die Zelle, dann quittieren Sie.
runs-server-gone = der Dienst ist nicht mehr da; der Roboter wurde gestoppt. Starten Sie den Dienst und quittieren Sie den Lauf.
runs-journal-not-writable = was mit dem Lauf geschieht, ließ sich nicht schreiben ({ $reason }); der Roboter wurde gestoppt. Schaffen Sie Platz auf der Festplatte.
runs-folder-not-writable = der Ordner des Laufs ließ sich nicht beschreiben ({ $reason }); der Roboter wurde gestoppt. Schaffen Sie Platz.
runs-folder-not-made = der Ordner des Laufs ließ sich nicht anlegen ({ $reason }); nichts hat sich bewegt. Schaffen Sie Platz, dann beginnen Sie einen neuen Lauf.
runs-release-not-kept = die Freigabe ließ sich nicht schreiben, darum hat sich nichts bewegt; prüfen Sie Datenbank und Festplatte, dann beginnen Sie einen neuen Lauf.
runs-control-process-lost = die Steuerung endete mit { $exit_code }; ihr Roboter bekam keine Befehle mehr. Sehen Sie im Protokoll nach.
runs-control-process-not-started = die Steuerung ließ sich nicht starten; nichts hat sich bewegt. Sehen Sie im Protokoll nach.
runs-planner-lost = die Planung endete unerwartet; beginnen Sie einen neuen Lauf.

# Was nicht zum Zustand eines Laufs passt.
runs-unknown = Lauf: keiner heißt „{ $run }“. Sehen Sie nach, welche es gibt, und versuchen Sie es noch einmal.
runs-command-not-possible = Lauf { $run }: { runs-command } ist im Zustand { runs-state } nicht möglich; möglich sind hier: { $commands }
runs-command-impossible = Lauf { $run }: { runs-command } ist im Zustand { runs-state } nicht möglich; möglich ist hier kein Befehl
runs-no-plan = Lauf { $run }: es gibt noch keinen Plan, er ist im Zustand { runs-state }; warten Sie, bis er auf seine Freigabe wartet
runs-no-result = Lauf { $run }: es gibt kein Ergebnis, er ist im Zustand { runs-state }
runs-no-result-because = Lauf { $run }: es gibt kein Ergebnis, er ist im Zustand { runs-state } ({ $cause })
runs-no-recording = Lauf { $run }: hat keine Aufzeichnung, er ist im Zustand { runs-state }; es gibt sie, sobald der Roboter sich bewegt hat und wieder steht
runs-no-report = Lauf { $run }: hat keinen Bericht, er ist im Zustand { runs-state }; ein Bericht kommt mit einem Lauf, der fertig ist
runs-recording-open = Lauf { $run }: seine Steuerung schließt noch die Aufzeichnung; versuchen Sie es in einigen Sekunden noch einmal
runs-nothing-left = Lauf { $run }: es gibt nichts fortzusetzen; er ist im Zustand { runs-state } und hat { $finished_steps } Schritte fertig. Beginnen Sie einen neuen Lauf
runs-recording-not-there = Lauf { $run }: seine Aufzeichnung ist (noch) nicht da; versuchen Sie es in einigen Sekunden noch einmal, oder beginnen Sie einen neuen Lauf
runs-accepted-already = Lauf { $run }: wurde schon angenommen, von { PERSON($who) }; ein Ergebnis wird einmal angenommen
runs-nothing-to-stop = Zelle „{ $cell }“: kein Lauf hat ihren Roboter, also gibt es nichts zu stoppen
runs-no-common-frame = Zelle „{ $cell }“: sagt nicht, wie ihr Sensor angebracht ist (sensor.mount); Läufe zweier Zellen haben so kein gemeinsames Koordinatensystem

# Aufträge, die nicht zur Zelle passen.
runs-speed-not-allowed = Die Höchstgeschwindigkeit des Laufs ist { SIGNIFICANT($speed_m_s, digits: 6) } m/s (speed_m_s); diese Zelle erlaubt { SIGNIFICANT($least_m_s, digits: 6) } bis { SIGNIFICANT($most_m_s, digits: 6) } m/s
runs-start-of-other-robot = start_rad hat { $given } Gelenkstellungen; dieser Roboter hat { $joints } Gelenke
runs-cell-without-payload =
    .found = keine Last in der Zelle „{ $cell }“
    .expected = eine, die der simulierte Roboter tragen kann; tragen Sie sie in cell.toml ein
runs-payload-unknown =
    .found = „{ $payload }“
    .expected = eines von { $payloads }, was die Zelle „{ $cell }“ kennt

# Die Bedienung einer Zelle, und Befehle, die zu spät kommen.
runs-control-taken = Bedienung der Zelle „{ $cell }“: { PERSON($holder) } hat sie; bitten Sie darum, sie abzugeben
runs-control-free = Bedienung der Zelle „{ $cell }“: niemand hat sie; übernehmen Sie sie
runs-control-elsewhere = Bedienung der Zelle „{ $cell }“: { PERSON($holder) } hat sie mit der Nummer { $fence }, nicht { PERSON($who) } mit { $sent_fence }
runs-control-asked = Bedienung der Zelle „{ $cell }“: { PERSON($who) } hat sie schon angefordert; es geht nur eine Anforderung nach der anderen
runs-control-not-asked = Bedienung der Zelle „{ $cell }“: diese Anforderung gilt nicht mehr
runs-control-overtaken = Bedienung der Zelle „{ $cell }“: jemand war schneller; sehen Sie nach, wer sie jetzt hat, und fordern Sie sie erneut an
runs-command-without-control = Befehl { runs-command }: braucht die Bedienung der Zelle „{ $cell }“; übernehmen Sie sie
runs-command-repeated = Befehl Nummer { $number }: nicht über dem letzten, { $last_number }; er ist wiederholt oder kam zu spät
runs-command-late = Befehl: { FIXED($age_s, digits: 3) } s alt (0 bis { SIGNIFICANT($limit_s) } s erlaubt); versuchen Sie es noch einmal

# Freigaben.
runs-plan-void = Plan { $plan }: gilt nicht mehr, Plan oder Zelle haben sich geändert; sehen Sie ihn noch einmal an
runs-offer-foreign = Freigabe: nicht für diesen Plan gemacht; sehen Sie ihn noch einmal an und geben Sie frei, was er zeigt
runs-offer-old = Freigabe: { FIXED($age_s, digits: 0) } s alt (Grenze { FIXED($limit_s, digits: 0) } s); sehen Sie den Plan noch einmal an und geben Sie frei, was er zeigt
runs-disk-too-full = Festplatte: { FIXED($free_mb, digits: 0) } MB sind frei, wo Läufe aufgezeichnet werden, dieser braucht bis zu { FIXED($needed_mb, digits: 0) } MB; schaffen Sie Platz und geben Sie dann noch einmal frei

# Wer zusieht, und wer benachrichtigt wird.
runs-watcher-too-slow = eine Nachricht ging nicht innerhalb von { SIGNIFICANT($limit_s) } s hinaus
runs-watcher-behind = mehr als { $events } Ereignisse warteten
runs-stamp-malformed = eine Antwort besteht aus fence, number, stamp_s und page_age_s
runs-webhook-unknown = Webhook: keiner heißt „{ $webhook }“. Sehen Sie nach, welche es gibt, und versuchen Sie es noch einmal.
runs-delivery-refused = der Empfänger hat mit HTTP { $status } geantwortet
runs-delivery-failed = keine Antwort von dieser Adresse: { $error } { $reason }
