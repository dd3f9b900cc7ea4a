/** Warum von zwei Körpern nichts verlangt wird: nach den englischen Worten des Dienstes, `{}` für das, was sie nennen. */
export const leftOut: Record<string, string> = {
  'no joint between them: they do not move against each other':
    'kein Gelenk zwischen ihnen: sie bewegen sich nicht gegeneinander',
  'they share a joint: their shapes meet there':
    'sie haben ein Gelenk gemeinsam: dort treffen sich ihre Formen',
  '{} mm apart at home already: simplified shapes of one wrist':
    '{} mm Abstand schon in der Grundstellung: vereinfachte Formen eines Handgelenks',
};
