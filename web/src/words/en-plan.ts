/** What was found when a finished plan was measured once more, by code that the planner does not use. */
export const secondLook = {
  title: 'Second opinion',
  how: (points: string) =>
    `Checked by code that the planner does not use, at all ${points} points of the motion. Every limit is kept.`,
  what: 'What',
  least: 'Measured',
  where: 'Where and when',
  kinds: {
    'obstacles, zones and floor': 'To obstacles, zones and the floor',
    'first link against obstacles, zones and floor': 'First link, which only turns on its base',
    'first links against what the robot is mounted on': 'First links to what the robot is mounted on',
    'payload against links': 'Payload to links',
    'links against links': 'Links to each other',
    'near each other by construction': 'Near each other by construction',
  } as Record<string, string>,
  fastest: 'Fastest point',
  limit: (limit: string) => `limit ${limit}`,
  mayTouch: 'must not penetrate each other',
  between: (first: string, second: string) => `${first} – ${second}`,
  corner: (body: string) => `corner of ${body}`,
  when: (part: string, time: string) => `${part}, after ${time}`,
  load: 'load',
  lost: 'Dropped load',
  past: (zone: string) => `past zone ${zone}`,
  torque: 'Largest joint torque',
  ofTorque: (torque: string, share: string) => `${torque}, ${share} %`,
  leftOut: (count: number) => `${count} pairs that are not checked, and why`,
};
