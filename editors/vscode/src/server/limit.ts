// How often something may happen within a span of time.

export class Limit {
  readonly #most: number;
  readonly #within: number;
  #times: number[] = [];

  /** At most `most` times within `within` milliseconds. */
  constructor(most: number, within: number) {
    this.#most = most;
    this.#within = within;
  }

  /** Whether it may happen once more now; counts it if so. */
  allows(now: number): boolean {
    this.#times = this.#times.filter(time => now - time < this.#within);
    if (this.#times.length >= this.#most) {
      return false;
    }
    this.#times.push(now);
    return true;
  }
}
