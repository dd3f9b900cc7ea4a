import type { FunctionComponent } from 'preact';

/** One page of the console. */
export interface Screen {
  Page: FunctionComponent;
  /** Its buttons, at the right end of the bar below. */
  Actions?: FunctionComponent;
  /** What comes next, as a sentence. */
  next: () => string;
}
