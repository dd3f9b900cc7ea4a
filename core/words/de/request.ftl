request-unfit = { $more ->
    [0] { $flaw }
   *[other] { $flaw }; und { $more } weitere, siehe `flaws`
}
request-no-json = { $flaw }
request-address-unknown = { $method } { $path }: unter dieser Adresse gibt es nichts; GET /openapi.json zeigt, was es gibt
request-method-not-allowed = { $method } { $path }: das geht unter dieser Adresse nicht; siehe `allowed`
request-body-too-large = { $method } { $path }: das sind mehr als { $limit_bytes } Byte; senden Sie weniger
request-refused = { $method } { $path }: { $reason }
request-unforeseen = ein unvorhergesehener Fehler; das Protokoll des Dienstes hat ihn unter request_id
request-key-busy = Idempotency-Key „{ $key }“: die erste Anfrage läuft noch; versuchen Sie es noch einmal
request-key-reused = Idempotency-Key „{ $key }“: wurde schon für etwas anderes gebraucht; nehmen Sie für eine neue Anfrage einen neuen
request-cell-unknown = Zelle: keine heißt „{ $cell }“. Sehen Sie nach, welche es gibt, und versuchen Sie es noch einmal.
request-problem-unknown = Fehler: keiner heißt „{ $problem }“. GET /openapi.json zeigt, was es gibt.
request-console-file-unknown = Datei der Konsole: keine heißt „{ $path }“. Laden Sie die Seite neu.
