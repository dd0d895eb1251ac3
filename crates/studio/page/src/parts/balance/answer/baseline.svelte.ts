// The state that changes are measured against: the engine as it was opened, or as marked by hand.

import { engine } from "../../../state/engine.svelte";

class Baseline {
  #marked = $state("");
  text = $derived(this.#marked || engine.first);

  constructor() {
    engine.whenOpened(() => (this.#marked = ""));
  }

  /** Marks the present state. */
  mark() {
    this.#marked = engine.valid;
  }
}

export const baseline = new Baseline();
