/** About the connection to the service, what is lost with it, and who may stop a robot without it. */
export const now = {
  active: 'Active runs on this service',
  none: 'No run is active on this service.',
  runs: (count: number) => (count === 1 ? '1 run is active' : `${count} runs are active`),
  stop: (cell: string) => `STOP ${cell}`,
  since: (time: string) => `since ${time}`,
  anybody: 'Anybody may stop a robot here, without signing in.',
};

export const lost = {
  title: 'No connection to the service',
  since: (time: string, span: string) => `Since ${time}, for ${span}`,
  cell: 'Cell',
  state: 'Last known state',
  stopsItself: (lease: string) =>
    `The robot stops by itself within ${lease} of a lost connection and keeps its place.`,
  keepsPlace: 'The robot was stopped when the connection was lost. It keeps its place until it is resumed.',
  others: (who: string) =>
    `${who} has control on another device. This screen does not know what the robot is doing now.`,
  notKnown: 'This screen does not know what the robot is doing now.',
  noStop: 'STOP on this screen does not work now. Stop the robot with the emergency stop at the robot.',
  again: 'This screen keeps trying. It shows the true state as soon as the connection is back.',
};

export const held = {
  late: {
    network: (mine: boolean, late: string, limit: string) =>
      `Connection to ${mine ? 'this console' : 'the console in control'} was late (${late}, limit ${limit}).`,
    page: (mine: boolean, late: string, limit: string) =>
      `The page of ${mine ? 'this console' : 'the console in control'} did not respond for ${late} (limit ${limit}): the tablet is too busy.`,
    service: (_mine: boolean, late: string, limit: string) =>
      `The service was late (${late}, limit ${limit}): its computer is too busy, or it was stopped.`,
    store: (_mine: boolean, late: string, limit: string) =>
      `The database was late (${late}, limit ${limit}). Nothing is lost.`,
    control_process: (_mine: boolean, late: string, limit: string) =>
      `The robot’s control process was late (${late}, limit ${limit}): its computer is too busy.`,
    sensor: (_mine: boolean, late: string, limit: string) =>
      `The force sensor’s values stood still (${late}, limit ${limit}): check its connection.`,
    robot: (_mine: boolean, late: string, limit: string) =>
      `The robot’s state was late (${late}, limit ${limit}): check the connection to the robot.`,
  },
  keepsPlace: 'Robot stopped, keeps its place.',
  stopped: 'Robot stopped.',
  waits: (left: string) => `Waits ${left} more for Resume, then the run ends; it can be continued later.`,
  next: 'Robot stopped. Resume continues the plan; STOP ends the run.',
  restoring: 'control is being restored',
  takesControl: 'takes control and resumes',
  goesOn: 'resumes along the plan',
};

export const link = {
  title: 'Connection of this screen',
  hint: (lease: string) =>
    `If the connection is lost for ${lease} the robot stops and waits. This tablet is not the emergency stop.`,
  measuring: 'being measured.',
  figures: (usual: string, mostly: string, lost: string, gap: string, lease: string) =>
    `round trip ${usual} (99 % below ${mostly}), lost ${lost}, longest gap ${gap} (limit ${lease}).`,
  poor: 'Over this connection the run would probably be put on hold. Move the tablet nearer to the access point or use a cable; you may release all the same.',
};

export const absent = {
  page: 'Page not found',
  run: 'Run not found',
  here: (address: string) => `There is nothing at ${address}.`,
  next: 'The address may be mistyped, or it belongs to another service. Continue from the start page.',
  start: 'Start page',
};

export const continuing = {
  finished: (done: number, steps: number) => `Finished and recorded: ${done} of ${steps} steps.`,
  act: 'Continue the run',
  next: 'Robot stopped. “Continue the run” plans the rest as a new run; nothing moves before you release it.',
  afterClear: 'Check the cell, then clear it. After that the rest of the run can be made.',
};
