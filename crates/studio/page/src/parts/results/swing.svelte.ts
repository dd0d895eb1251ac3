// A swing to and fro, as slow as one likes to look at it.

/** How long a swing takes on the screen [s]. */
const TIME = 1.6;

/** To be made while a component is set up: it ends with it. */
export class Swing {
  playing = $state(false);
  /** Within the swing [rad]; it begins at the largest deflection. */
  #phase = $state(Math.PI / 2);
  /** From -1 to 1. */
  readonly share = $derived(Math.sin(this.#phase));

  constructor() {
    $effect(() => {
      if (!this.playing) return;
      let before = performance.now();
      let frame = requestAnimationFrame(
        function go(this: Swing, now: number) {
          const seconds = Math.min(Math.max(now - before, 0), 250) / 1000;
          before = now;
          this.#phase = (this.#phase + (2 * Math.PI * seconds) / TIME) % (2 * Math.PI);
          frame = requestAnimationFrame(go.bind(this));
        }.bind(this),
      );
      return () => cancelAnimationFrame(frame);
    });
  }

  turn() {
    this.playing = !this.playing;
    if (!this.playing) this.#phase = Math.PI / 2;
  }
}
