import type { secondLook as enSecondLook } from './en-plan';

/** Was sich fand, als ein fertiger Plan noch einmal vermessen wurde, mit einem Programm, das der Planer nicht benutzt. */
export const secondLook: typeof enSecondLook = {
  title: 'Ein zweites Mal geprüft',
  how: (points) =>
    `Mit einem anderen Programm als dem des Planers, an allen ${points} Punkten der Bewegung. Alle Grenzen sind eingehalten.`,
  what: 'Was',
  least: 'Gemessen',
  where: 'Wo und wann',
  kinds: {
    'obstacles and zones': 'Zu Hindernissen und Zonen',
    'first link against obstacles and zones': 'Erstes Glied, das sich nur auf dem Sockel dreht',
    'payload against links': 'Last zu Gliedern',
    'links against links': 'Glieder zueinander',
    'neighbours in the arm': 'Nachbarn im Arm',
  },
  fastest: 'Schnellster Punkt',
  limit: (limit) => `Grenze ${limit}`,
  mayTouch: 'dürfen nicht ineinander',
  between: (first, second) => `${first} – ${second}`,
  corner: (body) => `${body} (eine Ecke)`,
  when: (part, time) => `${part}, nach ${time}`,
  load: 'Last',
  leftOut: (count) => `${count} Paare, die nicht beurteilt werden, und warum`,
};
