/** What goes wrong on this screen alone. */
export const mishaps = {
  unreachable: 'The service does not answer. Check the network, then try again.',
  'not-in-control': 'This screen is not in control. Take control, then try again.',
  'control-not-taken': 'Control was lost before it began. Take it again.',
};
