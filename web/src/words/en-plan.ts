/** What was found when a finished plan was measured once more, by code that the planner does not use. */
export const secondLook = {
  title: 'Checked a second time',
  how: (points: string) =>
    `By other code than the planner’s, at all ${points} points of the motion. Every limit is kept.`,
  what: 'What',
  least: 'Measured',
  where: 'Where and when',
  kinds: {
    'obstacles and zones': 'To obstacles and zones',
    'first link against obstacles and zones': 'First link, which only turns on its base',
    'payload against links': 'Load to links',
    'links against links': 'Links to each other',
    'neighbours in the arm': 'Neighbours in the arm',
  } as Record<string, string>,
  fastest: 'Fastest point',
  limit: (limit: string) => `limit ${limit}`,
  mayTouch: 'must not enter each other',
  between: (first: string, second: string) => `${first} – ${second}`,
  corner: (body: string) => `corner of ${body}`,
  when: (part: string, time: string) => `${part}, after ${time}`,
  load: 'load',
  leftOut: (count: number) => `${count} pairs that are not judged, and why`,
};
