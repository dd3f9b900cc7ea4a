import type { ProblemDetails } from '../api';
import type { Message } from '../words/catalogue';

/** A no of the service, in its own words. */
export class Refusal extends Error {
  constructor(readonly problem: ProblemDetails) {
    super(problem.detail);
  }

  /** What it says: the situation that its type names. */
  get said(): Message {
    const { type, parameters = {}, detail } = this.problem;
    return { code: type.slice(type.lastIndexOf('/') + 1), parameters, text: detail };
  }
}
