/** A line of a plot. */
export interface Line {
  /** What the legend calls it; one that begins with _ has no place there and comes and goes with the line of that name. */
  label: string;
  /** What it is called where there is no picture of it: at the crosshair and in a file. The label, where absent. */
  name?: string;
  /** Name of a colour in look/tokens.css. */
  colour: string;
  dashed?: boolean;
  /** What is drawn in place of a line through the values: a dot at each, bars from them to the next line's values, or nothing. */
  drawn?: 'dots' | 'bars' | 'not';
}

/** The lines that have a place in the legend. */
export function legendOf(lines: Line[]): Line[] {
  return lines.filter(({ label }) => !label.startsWith('_'));
}

/** What a line is called where there is no picture of it. */
export function nameOf({ label, name }: Line): string {
  return name ?? label.replace(/^_/, '');
}
