/** Why nothing could be planned, in the words of what was typed, and where that is changed. */
export const refusal = {
  carried: 'The tool’s box',
  inside: (first: string, depth: string, second: string) => `${first} reaches ${depth} into ${second}`,
  near: (first: string, distance: string, second: string, limit: string) =>
    `${first} is ${distance} from ${second}; at least ${limit} is required`,
  atHome: (what: string) => `${what} at home.`,
  atStart: (what: string) => `${what} where the robot starts.`,
  noStart: (axis: string) => `There is no room to hold sensor axis ${axis} along gravity.`,
  nearest: (distance: string, what: string) => `The best position found is ${distance} from ${what}.`,
  otherAxes: (axes: string) => `With the axes ${axes} alone there is a plan.`,
  noPath: 'There are positions with enough room, but no safe path between them was found.',
  tooHeavy: (joint: string, needed: string, limit: string) =>
    `The load is too heavy for ${joint}: it would need ${needed}, and has ${limit}.`,
  change: 'Change',
  fields: {
    box: 'Payload box',
    tool: 'Tool',
    axes: 'Sensor axes',
    speed: 'Speed limit',
    effort: 'Search effort',
    mass: 'Mass',
    home: 'Home position',
    zone: 'Protected zone',
  },
  details: 'Details',
  cancelled: 'The run was cancelled',
  cancelledNext: 'Nothing has moved. Start a new run when you are ready.',
  badBox: 'Enter three lengths above 0, such as 0.12 or 0,12',
  correct: {
    box: 'Correct the payload box first.',
    mass: 'Correct the mass first.',
    axes: 'Choose a sensor axis first.',
    speed: 'Correct the speed limit first.',
    cell: 'The cell is being loaded.',
  },
  badSpeed: (least: string, limit: string) => `Enter ${least} to ${limit}, or nothing`,
};
