// How long frames take: measured, not guessed.

/** The frames of the last second. */
export class FrameClock {
  #begun: number[] = [];
  #took: number[] = [];
  #start = -Infinity;

  /** When the last frame began [ms]. */
  get last(): number {
    return this.#start;
  }

  /** A frame begins [ms]. */
  begin(now: number) {
    this.#start = now;
    this.#begun.push(now);
    while ((this.#begun[0] ?? now) < now - 1000) {
      this.#begun.shift();
      this.#took.shift();
    }
  }

  /** Its commands are given [ms]. */
  end(now: number) {
    this.#took.push(now - this.#start);
  }

  /** Frames in a second and the mean time between two [ms]; `null` where there were fewer than two. */
  get rate(): { frames: number; between: number; work: number } | null {
    const [first, last] = [this.#begun[0], this.#begun.at(-1)];
    const count = this.#begun.length - 1;
    if (first === undefined || last === undefined || count < 1 || last <= first) return null;
    const between = (last - first) / count;
    const work = this.#took.reduce((sum, took) => sum + took, 0) / this.#took.length;
    return { frames: 1000 / between, between, work };
  }
}
