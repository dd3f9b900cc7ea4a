import type {
  absent as enAbsent,
  continuing as enContinuing,
  held as enHeld,
  link as enLink,
  lost as enLost,
  now as enNow,
} from './en-link';

/** Zur Verbindung mit dem Dienst, was mit ihr verloren geht, und wer einen Roboter ohne Anmeldung stoppen darf. */
export const now: typeof enNow = {
  active: 'Aktive Läufe auf diesem Dienst',
  none: 'Auf diesem Dienst ist kein Lauf aktiv.',
  runs: (count) => (count === 1 ? '1 Lauf ist aktiv' : `${count} Läufe sind aktiv`),
  stop: (cell) => `STOPP ${cell}`,
  since: (time) => `seit ${time}`,
  anybody: 'Jeder darf einen Roboter hier stoppen, auch ohne Anmeldung.',
};

export const lost: typeof enLost = {
  title: 'Keine Verbindung zum Dienst',
  since: (time, span) => `Seit ${time} (${span})`,
  cell: 'Zelle',
  state: 'Zuletzt bekannter Zustand',
  stopsItself: (lease) =>
    `Der Roboter stoppt von selbst innerhalb von ${lease} nach dem Verbindungsverlust und bleibt, wo er ist.`,
  keepsPlace:
    'Der Roboter war gestoppt, als die Verbindung verloren ging. Er bleibt, wo er ist, bis jemand fortfahren lässt.',
  others: (who) =>
    `${who} bedient an einem anderen Gerät. Dieser Bildschirm weiß nicht, was der Roboter jetzt tut.`,
  notKnown: 'Dieser Bildschirm weiß nicht, was der Roboter jetzt tut.',
  noStop:
    'STOPP auf diesem Bildschirm wirkt jetzt nicht. Stoppen Sie den Roboter mit dem Not-Halt am Roboter.',
  again:
    'Dieser Bildschirm versucht es weiter. Er zeigt den wahren Zustand, sobald die Verbindung wieder da ist.',
};

const toScreen = (mine: boolean) => (mine ? 'zu diesem Bildschirm' : 'zum bedienenden Bildschirm');
const onScreen = (mine: boolean) => (mine ? 'auf diesem Bildschirm' : 'auf dem bedienenden Bildschirm');

export const held: typeof enHeld = {
  late: {
    network: (mine, late, limit) =>
      `Die Verbindung ${toScreen(mine)} war zu langsam (${late}, Grenze ${limit}).`,
    page: (mine, late, limit) =>
      `Die Seite ${onScreen(mine)} reagierte ${late} lang nicht (Grenze ${limit}): das Tablet ist überlastet.`,
    service: (_mine, late, limit) =>
      `Der Dienst kam zu spät (${late}, Grenze ${limit}): sein Rechner ist überlastet, oder er wurde angehalten.`,
    store: (_mine, late, limit) =>
      `Die Datenbank kam zu spät (${late}, Grenze ${limit}). Nichts ist verloren.`,
    control_process: (_mine, late, limit) =>
      `Die Steuerung des Roboters kam zu spät (${late}, Grenze ${limit}): ihr Rechner ist überlastet.`,
    sensor: (_mine, late, limit) =>
      `Die Werte des Kraftsensors standen still (${late}, Grenze ${limit}): prüfen Sie seinen Anschluss.`,
    robot: (_mine, late, limit) =>
      `Der Zustand des Roboters kam zu spät (${late}, Grenze ${limit}): prüfen Sie die Verbindung zum Roboter.`,
  },
  keepsPlace: 'Roboter gestoppt, er bleibt, wo er ist.',
  stopped: 'Roboter gestoppt.',
  waits: (left) =>
    `Wartet noch ${left} auf Fortfahren, dann endet der Lauf; er kann später fortgesetzt werden.`,
  next: 'Roboter gestoppt. Fortfahren setzt den Plan fort; STOPP beendet den Lauf.',
  restoring: 'Bedienung wird wiederhergestellt',
  takesControl: 'übernimmt die Bedienung und fährt fort',
  goesOn: 'setzt den Plan fort',
};

export const link: typeof enLink = {
  title: 'Verbindung dieses Bildschirms',
  hint: (lease) =>
    `Ist die Verbindung ${lease} lang verloren, stoppt der Roboter und wartet. Dieses Tablet ist nicht der Not-Halt.`,
  measuring: 'wird gemessen.',
  figures: (usual, mostly, lost, gap, lease) =>
    `hin und zurück ${usual} (99 % unter ${mostly}), verloren ${lost}, längste Lücke ${gap} (Grenze ${lease}).`,
  poor: 'Über diese Verbindung würde der Lauf wahrscheinlich angehalten. Gehen Sie mit dem Tablet näher an den Zugangspunkt oder nehmen Sie ein Kabel; freigeben können Sie trotzdem.',
};

export const absent: typeof enAbsent = {
  page: 'Seite nicht gefunden',
  run: 'Lauf nicht gefunden',
  here: (address) => `Unter ${address} ist nichts.`,
  next: 'Vielleicht ist die Adresse falsch geschrieben, oder sie gehört zu einem anderen Dienst. Gehen Sie von der Startseite aus weiter.',
  start: 'Startseite',
};

export const continuing: typeof enContinuing = {
  finished: (done, steps) => `Fertig und aufgezeichnet: ${done} von ${steps} Schritten.`,
  act: 'Lauf fortsetzen',
  next: 'Roboter gestoppt. „Lauf fortsetzen“ plant den Rest als neuen Lauf; vor Ihrer Freigabe bewegt sich nichts.',
  afterClear: 'Prüfen Sie die Zelle, dann quittieren Sie. Danach kann der Rest des Laufs folgen.',
};
