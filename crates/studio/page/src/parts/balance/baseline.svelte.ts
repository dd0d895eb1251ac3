// The state that changes are measured against: the file as it was when it was opened, or as marked by hand.

import { engine } from "../../state/engine.svelte";

class Baseline {
  text = $state("");
  #file = "";

  /** Marks the present state. */
  mark() {
    this.text = engine.valid;
  }

  /** Another engine brings its own. */
  follow() {
    const file = engine.file?.name ?? engine.untitled;
    if (engine.valid !== "" && (this.text === "" || file !== this.#file)) {
      this.#file = file;
      this.mark();
    }
  }
}

export const baseline = new Baseline();
