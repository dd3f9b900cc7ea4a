/** Help and tour: what each screen is for, what can be done on it, what its words mean (docs/glossary.md). */
export const help = {
  can: 'What you can do here',
  words: 'Words on this screen',
  manual: 'Open the manual',
  pages: 'Pages of the manual',
  inEnglish: 'The manual is in English.',
  nextManual: 'Choose a page of the manual, or go on with your work.',
  noTour: 'The tour is not available while a robot moves.',
  screens: {
    signIn: {
      title: 'Sign in',
      what: 'Here you tell the service who you are. Anybody may stop a robot without signing in.',
      can: [
        'Sign in with the name and password that an administrator gave you.',
        'Press STOP beside a robot that is under way.',
      ],
    },
    setup: {
      title: 'Setting up a run',
      what: 'Here you say which robot is to find out what it carries, and what that is about as large as.',
      can: [
        'Choose the cell and the tool on the robot.',
        'Check the payload box: it has to enclose the whole tool, or parts of it may touch something.',
        'Plan. Nothing moves before you have seen the plan and released it.',
      ],
    },
    plan: {
      title: 'Reviewing the plan',
      what: 'Here you see everything that the robot is going to do, before it does it.',
      can: [
        'Play the path, and look at it from above and from where people stand.',
        'Check the smallest clearance and what happens if the load is dropped.',
        'Release the plan, then press START. The review is valid for one minute.',
      ],
    },
    running: {
      title: 'The robot is under way',
      what: 'The robot moves by itself and measures. You see what it does, what it has found so far, and what it is nearest to.',
      can: [
        'STOP ends the run; everybody may press it.',
        'Hold keeps the robot where it is; Resume goes on.',
        'If the connection of the screen in control is lost, the robot stops by itself and waits.',
      ],
    },
    result: {
      title: 'The result',
      what: 'Mass, centre of mass and inertia of what the robot carries, each with its uncertainty.',
      can: [
        'Compare the values with the reference and with the previous run.',
        'Accept the result: only then should it go into a controller.',
        'Download the payload for your controller, the report and the recording.',
      ],
    },
    ended: {
      title: 'The run has ended early',
      what: 'The run was stopped, refused or aborted. The page says why and what to do.',
      can: [
        'Remove the cause, then start a new run.',
        'Continue with the steps that are missing, where that is offered.',
        'Clear an aborted run after you have checked the cell.',
      ],
    },
    orders: {
      title: 'Orders',
      what: 'The queue of every cell: what people and the plant’s job system have ordered.',
      can: ['Open the run that waits for a release.', 'Cancel an order, and say why.'],
    },
    gap: {
      title: 'Diagnosis',
      what: 'Finds out why a robot’s measurements differ from its simulation: a tilted base, a cable that pulls, a late sensor.',
      can: [
        'Diagnose a run, or a recording of another robot.',
        'Follow the advice, or add what was found to the twin of the cell.',
        'Run the motion that is proposed where two causes cannot be told apart.',
      ],
    },
    trials: {
      title: 'Blind trials',
      what: 'Shows how good the diagnosis is: faults that nobody has chosen are planted in a simulated robot and have to be found.',
      can: ['Start one trial or ten.', 'Open the seal and see what had been planted.'],
    },
    history: {
      title: 'History',
      what: 'All runs of a cell, and how a parameter has changed over time.',
      can: [
        'Search by serial number, order, name or date; sort by a column.',
        'Open a run, or choose two and compare them.',
      ],
    },
    cells: {
      title: 'Cells and protected zones',
      what: 'What the robot knows of its surroundings: what it must not touch, and where people may be.',
      can: [
        'Drag, resize, turn, draw and delete protected zones, in the picture or by numbers.',
        'Put a zone back to how it was.',
        'Check a new cell and import it, as an engineer.',
      ],
    },
    alarms: {
      title: 'Alarms',
      what: 'Everything that needs a person, with what to do about it.',
      can: ['Acknowledge what you have seen.', 'Look at alarms that are over.'],
    },
    control: {
      title: 'Control',
      what: 'One person at a time has control of a cell: only they release, start, hold and resume. Anybody may stop.',
      can: [
        'Take control, release it, or ask whoever has it.',
        'Give this screen a name that others recognise.',
      ],
    },
    settings: {
      title: 'Settings',
      what: 'Language, units and colours of this screen. Nothing here changes what a robot does.',
      can: ['Choose language, units and theme.', 'Sign out.'],
    },
    admin: {
      title: 'Administration',
      what: 'Accounts, keys of machines, webhooks, the audit log and the state of the service.',
      can: [
        'Change your password, and sign out devices that you no longer use.',
        'Administrators add accounts and keys; engineers read the audit log.',
        'Download a support bundle when something is wrong.',
      ],
    },
    manual: {
      title: 'The manual',
      what: 'The documents that come with Heft.',
      can: ['Choose a page, or follow a link from one to another.'],
    },
  },
  terms: {
    run: ['Run', 'One pass on one robot, from the order to the result.'],
    order: ['Order', 'A run in the queue of its cell, from a person or from the plant’s job system.'],
    plan: ['Plan', 'Everything the robot is going to do in a run. It is shown before it is released.'],
    release: ['Release', 'A person’s consent to the very plan that was shown. Without it nothing moves.'],
    start: ['START', 'The tap after the release that begins the motion.'],
    control: ['Control', 'Who may start, hold and resume the robot of a cell: one person at a time.'],
    lease: ['Lease', 'How long control lasts without a sign of life from whoever has it.'],
    handover: ['Handover', 'Control passes to another screen that has asked for it.'],
    hold: ['Hold', 'The robot brakes and keeps its place; the run can go on.'],
    resume: ['Resume', 'The robot goes on from where it is, along the released plan.'],
    stop: ['STOP', 'The robot brakes and the run ends; what is recorded is kept. It is no emergency stop.'],
    abort: ['Abort', 'The run ends because something is wrong; the reason stands beside it.'],
    clear: ['Clear', 'Somebody has checked the cell after an abort; the next run may begin.'],
    guard: [
      'Guard',
      'Checks the robot all the time and stops it before a limit is broken. Not a safety function.',
    ],
    accept: ['Accept', 'A person takes a result for good.'],
    cell: ['Cell', 'A robot with its sensor, tools, obstacles and protected zones.'],
    payload: ['Payload', 'What the robot carries, and what is to be identified.'],
    payloadBox: ['Payload box', 'A box that certainly contains the payload, measured from the sensor.'],
    obstacle: ['Obstacle', 'Something that the robot must not touch.'],
    protectedZone: [
      'Protected zone',
      'Where people may be. The robot keeps its clearance, and no load that it drops falls into it.',
    ],
    clearance: ['Clearance', 'The distance that is kept to obstacles, protected zones and the floor.'],
    home: ['Home', 'The position in which every run begins and ends.'],
    startConfiguration: [
      'Start configuration',
      'A position from which a rotation about a sensor axis has room.',
    ],
    secondOpinion: ['Second opinion', 'A check of the finished plan that shares no code with the planner.'],
    interval: ['95 % interval', 'In 95 of 100 runs the true value lies within the ± that is stated.'],
    determined: ['Determined', 'A value is known well enough to be used; the others say why not.'],
    recording: ['Recording', 'The samples of a run and what is known of robot and sensor.'],
    gap: ['Gap', 'What is left of the measured forces when the simulation is taken off, beyond noise.'],
    effect: ['Effect', 'Something that the simulation lacks, such as a tilted base.'],
    twin: ['Twin', 'What has been added to a cell’s simulation, and where that comes from.'],
    closure: ['Improvement', 'The share of the gap that is gone once an effect is added.'],
    tie: ['Not settled', 'Several effects explain a recording equally well.'],
    blindTrial: ['Blind trial', 'A fault is planted and sealed, diagnosed, then the seal is opened.'],
    alarm: ['Alarm', 'Something that needs a person.'],
    acknowledge: ['Acknowledge', 'Say that you have seen an alarm. It stays until it is over.'],
  } as Record<TermName, [string, string]>,
  tour: {
    title: 'Tour',
    count: (step: number, steps: number) => `Tour: ${step} of ${steps}`,
    next: 'Next',
    back: 'Back',
    skip: 'Skip the tour',
    finish: 'Finish',
    steps: {
      frame:
        'At the top of every screen: the cell, what its robot is doing, who has control, whether there is a connection, and alarms.',
      tool: 'A run begins here: choose what the robot carries. The payload box has to enclose all of it.',
      plan: 'Then plan, with the button at the lower right. Planning moves nothing.',
      release:
        'The plan is shown with its path and clearances. Review it, tap Release…, then START: only START moves the robot. This line always says what comes next.',
      stop: 'While a run is active, STOP stands at the left of this bar, on every screen. Anybody may press it. It does not replace the emergency stop.',
      result:
        'The result appears when the robot is back at home: mass, centre of mass and inertia, each with its uncertainty. Check it, accept it, download it for your controller.',
      help: 'This button explains each screen and its words, and has the tour and the manual. That is all.',
    },
  },
};

type TermName =
  | 'run'
  | 'order'
  | 'plan'
  | 'release'
  | 'start'
  | 'control'
  | 'lease'
  | 'handover'
  | 'hold'
  | 'resume'
  | 'stop'
  | 'abort'
  | 'clear'
  | 'guard'
  | 'accept'
  | 'cell'
  | 'payload'
  | 'payloadBox'
  | 'obstacle'
  | 'protectedZone'
  | 'clearance'
  | 'home'
  | 'startConfiguration'
  | 'secondOpinion'
  | 'interval'
  | 'determined'
  | 'recording'
  | 'gap'
  | 'effect'
  | 'twin'
  | 'closure'
  | 'tie'
  | 'blindTrial'
  | 'alarm'
  | 'acknowledge';
