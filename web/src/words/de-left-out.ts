/** Warum von zwei Körpern nichts verlangt wird: nach den englischen Worten des Dienstes, `{}` für das, was sie nennen. */
export const leftOut: Record<string, string> = {
  'no joint between them: they do not move against each other':
    'kein Gelenk zwischen ihnen: sie bewegen sich nicht gegeneinander',
  'declared in the cell: robot.adjacent': 'in der Zelle so erklärt: robot.adjacent',
  'neighbours: one joint joins them': 'Nachbarn: ein Gelenk verbindet sie',
  'their shapes overlap at every angle: by construction':
    'ihre Formen überschneiden sich bei jedem Winkel: das liegt am Bau',
};
