import type { Problem } from '../api';

/** A no of the service, in its own words. */
export class Refusal extends Error {
  constructor(readonly problem: Problem) {
    super(problem.detail);
  }
}
