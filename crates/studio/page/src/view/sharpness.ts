// How finely moving pictures are drawn where a processor draws: coarser where frames come too slowly, finer again where
// there is time.

/** Pixels of the picture for each one of the screen, along each side. */
const FULL = 1;
const LEAST = 0.6;
const STEP = 0.1;
/** So many frames are looked at together: half a second at the goal. */
const FRAMES = 15;
/** From frame to frame [ms]: the goal, and what is let pass before it is drawn more coarsely. */
const GOAL = 1000 / 30;
const SLOW = 1.05 * GOAL;

export class Sharpness {
  #steps = 0;
  #frames = 0;
  #time = 0;

  get ratio(): number {
    return ratioAt(this.#steps);
  }

  /** A frame came so long after the one before [ms]. */
  frame(between: number) {
    this.#frames += 1;
    this.#time += between;
    if (this.#frames < FRAMES) return;
    const mean = this.#time / this.#frames;
    this.#frames = this.#time = 0;
    if (mean > SLOW) {
      if (ratioAt(this.#steps + 1) >= LEAST) this.#steps += 1;
    } else if (this.#steps > 0) {
      // Time goes at most with the number of pixels: what is finer then stays within the goal, and nothing swings.
      const finer = ratioAt(this.#steps - 1);
      if (mean * (finer / this.ratio) ** 2 < GOAL) this.#steps -= 1;
    }
  }
}

function ratioAt(steps: number): number {
  return Math.round(10 * (FULL - STEP * steps)) / 10;
}
