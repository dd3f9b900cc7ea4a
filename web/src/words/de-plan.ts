import type { secondLook as enSecondLook } from './en-plan';

/** Was sich fand, als ein fertiger Plan noch einmal vermessen wurde, mit einem Programm, das der Planer nicht benutzt. */
export const secondLook: typeof enSecondLook = {
  title: 'Zweitprüfung',
  how: (points) =>
    `Geprüft mit einem Programm, das der Planer nicht benutzt, an allen ${points} Punkten der Bewegung. Alle Grenzen sind eingehalten.`,
  what: 'Was',
  least: 'Gemessen',
  where: 'Wo und wann',
  kinds: {
    'obstacles, zones and floor': 'Zu Hindernissen, Zonen und Boden',
    'first link against obstacles, zones and floor': 'Erstes Glied, das sich nur auf dem Sockel dreht',
    'first links against what the robot is mounted on': 'Erste Glieder zu dem, worauf der Roboter steht',
    'payload against links': 'Last zu Gliedern',
    'links against links': 'Glieder zueinander',
    'near each other by construction': 'Bauartbedingt nah beieinander',
  },
  fastest: 'Schnellster Punkt',
  limit: (limit) => `Grenze ${limit}`,
  mayTouch: 'dürfen nicht ineinander eindringen',
  between: (first, second) => `${first} – ${second}`,
  corner: (body) => `${body} (eine Ecke)`,
  when: (part, time) => `${part}, nach ${time}`,
  load: 'Last',
  lost: 'Abfallende Last',
  past: (zone) => `vorbei an Zone ${zone}`,
  torque: 'Größtes Gelenkmoment',
  ofTorque: (torque, share) => `${torque}, ${share} %`,
  leftOut: (count) => `${count} Paare, die nicht geprüft werden, und warum`,
};
