/** What went wrong, by its kind. The service says it in English and in more detail: words are needed for what it cannot say alone. */
export const problems: Record<string, string> = {
  unreachable: 'The service does not answer. Look at the network, then try again.',
  'not-in-control': 'This screen is not in control. Take control, then try again.',
  'control-not-taken': 'Control was lost before it began. Take it again.',

  'network-late': 'The connection to the console in control was late. Robot stopped, keeps its place.',
  'page-late': 'The page of the console in control did not respond. Robot stopped, keeps its place.',
  'service-late': 'The service was late. Robot stopped, keeps its place.',
  'store-late': 'The database was late. Robot stopped, keeps its place.',
  'control-process-late': 'The robot’s control process was late. Robot stopped, keeps its place.',
  'sensor-frozen': 'The force sensor’s values stood still. Robot stopped.',
  'robot-state-late': 'The robot’s state was late. Robot stopped.',
  'hold-expired':
    'Nobody took control of the robot while it was on hold, so the run ended. The rest can be made as a new run.',
  'no-room': 'The disk is too full for a run. Make room.',
  'release-not-kept':
    'The release could not be written down, so nothing has moved. Look at the database and the disk, then make a new run.',
};
