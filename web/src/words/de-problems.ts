/** Was schiefging, nach seiner Art, und was zu tun ist; genauer sagt es der Dienst auf Englisch. */
export const problems: Record<string, string> = {
  unreachable: 'Der Dienst antwortet nicht. Prüfen Sie das Netz und versuchen Sie es noch einmal.',
  'not-in-control':
    'Dieser Bildschirm hat die Bedienung nicht. Übernehmen Sie sie und versuchen Sie es noch einmal.',
  'control-not-taken': 'Die Bedienung ging verloren, bevor sie begann. Übernehmen Sie sie noch einmal.',

  'stop-asked': 'Der Lauf wurde auf Wunsch beendet.',
  'abort-asked': 'Der Lauf wurde auf Wunsch abgebrochen.',
  'hold-asked': 'Der Lauf wurde auf Wunsch angehalten.',
  'clear-asked': 'Der Abbruch wurde quittiert.',
  cancelled: 'Zurückgenommen, bevor es fertig war.',
  'shut-down': 'Der Dienst wurde beendet; der Roboter wurde gestoppt.',
  'service-ended':
    'Der Dienst endete während des Laufs; der Roboter wurde gestoppt. Sehen Sie nach der Zelle, dann quittieren Sie.',
  'network-late':
    'Die Verbindung zum bedienenden Bildschirm war zu langsam. Roboter gestoppt, er bleibt, wo er ist.',
  'page-late':
    'Die Seite auf dem bedienenden Bildschirm reagierte nicht. Roboter gestoppt, er bleibt, wo er ist.',
  'service-late': 'Der Dienst kam zu spät. Roboter gestoppt, er bleibt, wo er ist.',
  'store-late': 'Die Datenbank kam zu spät. Roboter gestoppt, er bleibt, wo er ist.',
  'control-process-late': 'Die Steuerung des Roboters kam zu spät. Roboter gestoppt, er bleibt, wo er ist.',
  'release-not-kept':
    'Die Freigabe ließ sich nicht festhalten; nichts hat sich bewegt. Sehen Sie nach Datenbank und Platte, dann beginnen Sie einen neuen Lauf.',
  'control-process-lost': 'Die Steuerung des Roboters endete unerwartet; er bekam keine Befehle mehr.',
  'planner-lost': 'Die Planung endete unerwartet. Beginnen Sie einen neuen Lauf.',
  'work-lost': 'Die Rechnung endete unerwartet. Fordern Sie sie noch einmal an.',
  'no-room': 'Die Platte ist zu voll für einen Lauf. Schaffen Sie Platz.',

  refused: 'Die Zelle lässt dafür keinen sicheren Weg. Der Roboter hat sich nicht bewegt.',
  'no-start-configuration':
    'Keine Startstellung ist sicher. Räumen Sie weg, was im Weg ist, oder verkleinern Sie Hüllquader oder Abstand.',
  'no-path': 'Kein Weg zwischen den Stellungen ist frei und schnell genug. Räumen Sie weg, was im Weg ist.',
  'too-heavy':
    'Die Last ist zu schwer für den Roboter: einem Gelenk fehlt das Drehmoment. Nehmen Sie eine leichtere.',
  'plan-disputed':
    'Die unabhängige Prüfung bestätigt den fertigen Plan nicht. Der Roboter hat sich nicht bewegt. Planen Sie neu.',
  stopped: 'Der Wächter hat den Roboter gestoppt.',
  'too-close':
    'Der Wächter hat den Roboter gestoppt: zu nah an einem Hindernis, einer Zone oder sich selbst.',
  'too-fast': 'Der Wächter hat den Roboter gestoppt: zu schnell.',
  'out-of-limits': 'Der Wächter hat den Roboter gestoppt: ein Gelenk verließ seinen Bereich.',
  'over-load': 'Der Wächter hat den Roboter gestoppt: Kraft oder Moment am Handgelenk zu groß.',
  'bad-state':
    'Der Wächter hat den Roboter gestoppt: was Roboter oder Sensor melden, ist veraltet, leer oder widersprüchlich.',
  'sensor-frozen': 'Die Werte des Kraftsensors standen still. Roboter gestoppt.',
  'robot-state-late': 'Der Zustand des Roboters kam zu spät. Roboter gestoppt.',
  held: 'Der Roboter steht, bis er fortfahren soll.',
  'hold-expired':
    'Niemand übernahm die Bedienung, während der Roboter angehalten war; darum endete der Lauf. Sein Rest kann als neuer Lauf folgen.',
  commanded: 'Der Lauf wurde beendet.',
  'control-lost':
    'Niemand hatte mehr die Bedienung; der Roboter wurde gestoppt. Übernehmen Sie sie und lassen Sie ihn fortfahren.',
  interrupted: 'Der Lauf wurde unterbrochen; der Roboter wurde gestoppt.',

  'bad-input': 'Eine Angabe ist nicht brauchbar.',
  'bad-cell': 'Die Zelle ist nicht brauchbar.',
  'bad-robot': 'Das Modell des Roboters ist nicht brauchbar.',
  'bad-payload': 'So kann kein starrer Körper sein, oder etwas ist nicht bestimmt.',
  'bad-twin': 'Der Zwilling der Zelle ist nicht brauchbar, oder der Effekt passt nicht hinein.',
  'bad-recording': 'Die Aufzeichnung ist nicht brauchbar.',
  'bad-request':
    'Eine Angabe ist nicht brauchbar: sie fehlt, ist keine Zahl oder liegt außerhalb ihres Bereichs.',

  'not-signed-in': 'Niemand ist angemeldet, oder Name und Passwort stimmen nicht.',
  'not-allowed': 'Dieses Konto darf das nicht.',
  'not-found': 'Das gibt es nicht oder nicht mehr.',
  conflict: 'Das passt nicht zum augenblicklichen Zustand.',
  unprocessable: 'Das ist so nicht möglich.',
  'too-large': 'Das ist zu groß.',
  'too-many': 'Zu oft versucht. Warten Sie etwas.',
  'method-not-allowed': 'Das geht unter dieser Adresse nicht.',
  'store-unavailable':
    'Die Datenbank lässt sich jetzt nicht beschreiben. Versuchen Sie es in einigen Sekunden noch einmal.',
  'http-error': 'Die Anfrage ist nicht brauchbar.',
  'heft-error': 'Ein unerwarteter Fehler. Das Protokoll des Dienstes weiß mehr.',
  'service-error': 'Ein unerwarteter Fehler. Das Protokoll des Dienstes weiß mehr.',
  'internal-error': 'Ein unerwarteter Fehler. Das Protokoll des Dienstes weiß mehr.',
};
