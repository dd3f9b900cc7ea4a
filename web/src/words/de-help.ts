import type * as en from './en-help';

export const help: typeof en.help = {
  can: 'Was Sie hier tun können',
  words: 'Begriffe auf diesem Bildschirm',
  manual: 'Handbuch öffnen',
  pages: 'Seiten des Handbuchs',
  inEnglish: 'Das Handbuch gibt es auf Englisch.',
  nextManual: 'Wählen Sie eine Seite des Handbuchs, oder arbeiten Sie weiter.',
  noTour: 'Solange sich ein Roboter bewegt, gibt es keine Führung.',
  screens: {
    signIn: {
      title: 'Anmelden',
      what: 'Hier sagen Sie dem Dienst, wer Sie sind. Stoppen darf einen Roboter jeder, auch ohne Anmeldung.',
      can: [
        'Melden Sie sich mit dem Namen und dem Passwort an, die Sie bekommen haben.',
        'Drücken Sie STOPP neben einem Roboter, der unterwegs ist.',
      ],
    },
    setup: {
      title: 'Einen Lauf vorbereiten',
      what: 'Hier geben Sie an, welcher Roboter herausfinden soll, was er trägt, und wie groß das ungefähr ist.',
      can: [
        'Wählen Sie die Zelle und das Werkzeug am Roboter.',
        'Prüfen Sie den Hüllquader: Er muss das ganze Werkzeug umschließen, sonst können Teile davon anstoßen.',
        'Planen Sie. Nichts bewegt sich, bevor Sie den Plan gesehen und freigegeben haben.',
      ],
    },
    plan: {
      title: 'Den Plan prüfen',
      what: 'Hier sehen Sie alles, was der Roboter tun wird, bevor er es tut.',
      can: [
        'Spielen Sie die Bahn ab und sehen Sie sie von oben und vom Platz der Menschen aus an.',
        'Prüfen Sie den kleinsten Abstand und was geschieht, falls die Last abfällt.',
        'Geben Sie den Plan frei und drücken Sie dann START. Die Prüfung gilt eine Minute.',
      ],
    },
    running: {
      title: 'Der Roboter ist unterwegs',
      what: 'Der Roboter bewegt sich selbst und misst. Sie sehen, was er tut, was er bisher gefunden hat und wem er am nächsten ist.',
      can: [
        'STOPP beendet den Lauf; jeder darf drücken.',
        'Anhalten lässt den Roboter, wo er ist; Fortfahren macht weiter.',
        'Verliert der bedienende Bildschirm die Verbindung, stoppt der Roboter von selbst und wartet.',
      ],
    },
    result: {
      title: 'Das Ergebnis',
      what: 'Masse, Schwerpunkt und Trägheit dessen, was der Roboter trägt, jeweils mit Unsicherheit.',
      can: [
        'Vergleichen Sie die Werte mit der Referenz und mit dem vorigen Lauf.',
        'Nehmen Sie das Ergebnis an: Erst dann gehört es in eine Steuerung.',
        'Laden Sie die Last für Ihre Steuerung, den Bericht und die Aufzeichnung herunter.',
      ],
    },
    ended: {
      title: 'Der Lauf ist vorzeitig zu Ende',
      what: 'Der Lauf wurde gestoppt, abgelehnt oder abgebrochen. Die Seite sagt, warum und was zu tun ist.',
      can: [
        'Beheben Sie die Ursache und beginnen Sie einen neuen Lauf.',
        'Setzen Sie den Lauf mit den fehlenden Schritten fort, wo das angeboten wird.',
        'Quittieren Sie einen abgebrochenen Lauf, nachdem Sie die Zelle geprüft haben.',
      ],
    },
    orders: {
      title: 'Aufträge',
      what: 'Die Warteschlange jeder Zelle: was Menschen und das Leitsystem beauftragt haben.',
      can: [
        'Öffnen Sie den Lauf, der auf seine Freigabe wartet.',
        'Stornieren Sie einen Auftrag und sagen Sie, warum.',
      ],
    },
    gap: {
      title: 'Diagnose',
      what: 'Findet heraus, warum die Messwerte eines Roboters von seiner Simulation abweichen: ein geneigter Sockel, ein ziehendes Kabel, ein verspäteter Sensor.',
      can: [
        'Untersuchen Sie einen Lauf oder die Aufzeichnung eines anderen Roboters.',
        'Folgen Sie dem Rat, oder nehmen Sie das Gefundene in den Zwilling der Zelle auf.',
        'Führen Sie die vorgeschlagene Bewegung aus, wenn zwei Ursachen nicht zu unterscheiden sind.',
      ],
    },
    trials: {
      title: 'Blindversuche',
      what: 'Zeigt, wie gut die Diagnose ist: In einem simulierten Roboter werden Fehler versteckt, die niemand ausgesucht hat und die zu finden sind.',
      can: [
        'Starten Sie einen Versuch oder zehn.',
        'Öffnen Sie das Siegel und sehen Sie, was versteckt war.',
      ],
    },
    history: {
      title: 'Verlauf',
      what: 'Alle Läufe einer Zelle, und wie sich eine Größe über die Zeit verändert hat.',
      can: [
        'Suchen Sie nach Seriennummer, Auftrag, Name oder Datum; sortieren Sie nach einer Spalte.',
        'Öffnen Sie einen Lauf, oder wählen Sie zwei und vergleichen Sie sie.',
      ],
    },
    cells: {
      title: 'Zellen und Schutzzonen',
      what: 'Was der Roboter von seiner Umgebung weiß: was er nicht berühren darf, und wo Menschen sein können.',
      can: [
        'Schutzzonen ziehen, vergrößern, drehen, zeichnen und löschen, im Bild oder mit Zahlen.',
        'Eine Zone wiederherstellen, wie sie war.',
        'Als Ingenieur eine neue Zelle prüfen und importieren.',
      ],
    },
    alarms: {
      title: 'Alarme',
      what: 'Alles, was einen Menschen braucht, und was zu tun ist.',
      can: ['Quittieren Sie, was Sie gesehen haben.', 'Sehen Sie vergangene Alarme an.'],
    },
    control: {
      title: 'Bedienung',
      what: 'Immer nur eine Person bedient eine Zelle: Nur sie gibt frei, startet, hält an und lässt fortfahren. Stoppen darf jeder.',
      can: [
        'Die Bedienung übernehmen, abgeben oder anfordern.',
        'Diesem Bildschirm einen Namen geben, den andere erkennen.',
      ],
    },
    settings: {
      title: 'Einstellungen',
      what: 'Sprache, Einheiten und Farben dieses Bildschirms. Nichts davon ändert, was ein Roboter tut.',
      can: ['Sprache, Einheiten und Farbschema wählen.', 'Abmelden.'],
    },
    admin: {
      title: 'Verwaltung',
      what: 'Konten, Schlüssel von Maschinen, Webhooks, das Audit-Protokoll und der Zustand des Dienstes.',
      can: [
        'Das eigene Passwort ändern und Geräte abmelden, die Sie nicht mehr benutzen.',
        'Administratoren legen Konten und Schlüssel an; Ingenieure lesen das Audit-Protokoll.',
        'Ein Support-Paket herunterladen, wenn etwas nicht stimmt.',
      ],
    },
    manual: {
      title: 'Das Handbuch',
      what: 'Die Dokumente, die zu Heft gehören.',
      can: ['Wählen Sie eine Seite, oder folgen Sie den Verweisen.'],
    },
  },
  terms: {
    run: ['Lauf', 'Ein Durchgang an einem Roboter, vom Auftrag bis zum Ergebnis.'],
    order: ['Auftrag', 'Ein Lauf in der Warteschlange seiner Zelle, von einem Menschen oder vom Leitsystem.'],
    plan: [
      'Plan',
      'Alles, was der Roboter in einem Lauf tun wird. Er wird gezeigt, bevor er freigegeben wird.',
    ],
    release: [
      'Freigabe',
      'Die Zustimmung eines Menschen zu genau dem Plan, der gezeigt wurde. Ohne sie bewegt sich nichts.',
    ],
    start: ['START', 'Der Druck nach der Freigabe, mit dem die Bewegung beginnt.'],
    control: [
      'Bedienung',
      'Wer den Roboter einer Zelle starten, anhalten und fortfahren lassen darf: immer eine Person.',
    ],
    lease: ['Frist', 'So lange gilt die Bedienung ohne Lebenszeichen von dem, der sie hat.'],
    handover: ['Übergabe', 'Die Bedienung geht an einen anderen Bildschirm, der sie angefordert hat.'],
    hold: ['Anhalten', 'Der Roboter bremst und bleibt, wo er ist; der Lauf kann weitergehen.'],
    resume: ['Fortfahren', 'Der Roboter macht weiter, wo er ist, entlang des freigegebenen Plans.'],
    stop: ['STOPP', 'Der Roboter bremst und der Lauf endet; was aufgezeichnet ist, bleibt. Kein Not-Halt.'],
    abort: ['Abbruch', 'Der Lauf endet, weil etwas nicht stimmt; der Grund steht dabei.'],
    clear: ['Quittieren', 'Jemand hat die Zelle nach einem Abbruch geprüft; der nächste Lauf darf beginnen.'],
    guard: [
      'Überwachung',
      'Prüft den Roboter ständig und stoppt ihn, bevor eine Grenze verletzt wird. Keine Sicherheitsfunktion.',
    ],
    accept: ['Annehmen', 'Ein Mensch erklärt ein Ergebnis für gültig.'],
    cell: ['Zelle', 'Ein Roboter mit Sensor, Werkzeugen, Hindernissen und Schutzzonen.'],
    payload: ['Last', 'Was der Roboter trägt und was bestimmt werden soll.'],
    payloadBox: ['Hüllquader', 'Ein Quader, der die Last sicher enthält, vom Sensor aus gemessen.'],
    obstacle: ['Hindernis', 'Etwas, das der Roboter nicht berühren darf.'],
    protectedZone: [
      'Schutzzone',
      'Wo Menschen sein können. Der Roboter hält Abstand, und keine abfallende Last fällt hinein.',
    ],
    clearance: ['Mindestabstand', 'Der Abstand, der zu Hindernissen, Schutzzonen und Boden gehalten wird.'],
    home: ['Grundstellung', 'Die Stellung, in der jeder Lauf beginnt und endet.'],
    startConfiguration: [
      'Startstellung',
      'Eine Stellung, von der aus eine Drehung um eine Sensorachse Platz hat.',
    ],
    secondOpinion: ['Zweitprüfung', 'Eine Prüfung des fertigen Plans, die mit dem Planer keinen Code teilt.'],
    interval: ['95-%-Intervall', 'In 95 von 100 Läufen liegt der wahre Wert innerhalb des angegebenen ±.'],
    determined: [
      'Bestimmt',
      'Ein Wert ist genau genug bekannt, um ihn zu verwenden; bei den anderen steht, warum nicht.',
    ],
    recording: ['Aufzeichnung', 'Die Messwerte eines Laufs und was über Roboter und Sensor bekannt ist.'],
    gap: [
      'Abweichung',
      'Was von den gemessenen Kräften bleibt, wenn man die Simulation abzieht, über das Rauschen hinaus.',
    ],
    effect: ['Effekt', 'Etwas, das der Simulation fehlt, etwa ein geneigter Sockel.'],
    twin: ['Zwilling', 'Was der Simulation einer Zelle hinzugefügt wurde, und woher es stammt.'],
    closure: ['Verbesserung', 'Der Anteil der Abweichung, der verschwindet, wenn ein Effekt hinzukommt.'],
    tie: ['Nicht entschieden', 'Mehrere Effekte erklären eine Aufzeichnung gleich gut.'],
    blindTrial: [
      'Blindversuch',
      'Ein Fehler wird versteckt und versiegelt, untersucht, dann wird das Siegel geöffnet.',
    ],
    alarm: ['Alarm', 'Etwas, das einen Menschen braucht.'],
    acknowledge: [
      'Quittieren (Alarm)',
      'Sagen, dass Sie den Alarm gesehen haben. Er bleibt, bis er vorbei ist.',
    ],
  },
  tour: {
    title: 'Führung',
    count: (step, steps) => `Führung: ${step} von ${steps}`,
    next: 'Weiter',
    back: 'Zurück',
    skip: 'Führung beenden',
    finish: 'Fertig',
    steps: {
      frame:
        'Oben auf jedem Bildschirm: die Zelle, was ihr Roboter tut, wer bedient, ob es eine Verbindung gibt, und Alarme.',
      tool: 'Hier beginnt ein Lauf: Wählen Sie, was der Roboter trägt. Der Hüllquader muss alles davon umschließen.',
      plan: 'Dann planen Sie, mit der Taste unten rechts. Beim Planen bewegt sich nichts.',
      release:
        'Der Plan wird mit Bahn und Abständen gezeigt. Prüfen Sie ihn, tippen Sie auf „Freigeben…“, dann auf START: Erst START bewegt den Roboter. Diese Zeile sagt immer, was als Nächstes kommt.',
      stop: 'Solange ein Lauf aktiv ist, steht links in dieser Leiste STOPP, auf jedem Bildschirm. Jeder darf drücken. Den Not-Halt ersetzt er nicht.',
      result:
        'Das Ergebnis erscheint, sobald der Roboter in der Grundstellung ist: Masse, Schwerpunkt und Trägheit, jeweils mit Unsicherheit. Prüfen Sie es, nehmen Sie es an, laden Sie es für Ihre Steuerung herunter.',
      help: 'Diese Taste erklärt jeden Bildschirm und seine Begriffe; dort finden Sie auch die Führung und das Handbuch. Das war alles.',
    },
  },
};
