/** What went wrong, by its kind. The service says it in English and in more detail: words are needed for what it cannot say alone. */
export const problems: Record<string, string> = {
  unreachable: 'The service does not answer. Look at the network, then try again.',
  'not-in-control': 'This screen is not in control. Take control, then try again.',
  'control-not-taken': 'Control was lost before it began. Take it again.',
};
