import type { Words } from './en';

export const refusal: Words['refusal'] = {
  carried: 'Der Hüllquader des Werkzeugs',
  inside: (first, depth, second) => `${first} ragt ${depth} in ${second} hinein`,
  near: (first, distance, second, limit) =>
    `${first} ist ${distance} von ${second} entfernt; verlangt sind mindestens ${limit}`,
  atHome: (what) => `In der Grundstellung: ${what}.`,
  atStart: (what) => `Am Startpunkt des Roboters: ${what}.`,
  noStart: (axis) => `Es ist kein Platz, um Sensorachse ${axis} längs der Schwerkraft zu halten.`,
  nearest: (distance, what) => `Die beste gefundene Stellung ist ${distance} von ${what} entfernt.`,
  otherAxes: (axes) => `Mit den Achsen ${axes} allein gibt es einen Plan.`,
  noPath: 'Es gibt Stellungen mit genug Platz, aber keine sichere Bahn zwischen ihnen wurde gefunden.',
  tooHeavy: (joint, needed, limit) =>
    `Die Last ist zu schwer für ${joint}: nötig wären ${needed}, möglich sind ${limit}.`,
  change: 'Ändern',
  fields: {
    box: 'Hüllquader',
    tool: 'Werkzeug',
    axes: 'Sensorachsen',
    speed: 'Höchst\u00ADgeschwindig\u00ADkeit',
    effort: 'Suchaufwand',
    mass: 'Masse',
    home: 'Grundstellung',
    zone: 'Schutzzone',
  },
  details: 'Einzelheiten',
  cancelled: 'Der Lauf wurde storniert',
  cancelledNext: 'Der Roboter hat sich nicht bewegt. Beginnen Sie einen neuen Lauf, wenn Sie bereit sind.',
  badBox: 'Geben Sie drei Längen über 0 an, etwa 0,12 oder 0.12',
  correct: {
    box: 'Berichtigen Sie zuerst den Hüllquader.',
    mass: 'Berichtigen Sie zuerst die Masse.',
    axes: 'Wählen Sie zuerst eine Sensorachse.',
    speed: 'Berichtigen Sie zuerst die Höchst\u00ADgeschwindig\u00ADkeit.',
    cell: 'Die Zelle wird geladen.',
  },
  badSpeed: (least, limit) => `Geben Sie ${least} bis ${limit} an, oder nichts`,
};
