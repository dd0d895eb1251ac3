// The engine in short, as of the last text that made an engine: cards stay while a value is half typed.

import type { EngineSummary } from "../../api/types";
import { engine } from "../../state/engine.svelte";

class Summary {
  #last: EngineSummary | undefined;
  now = $derived.by(() => {
    this.#last = engine.reading?.engine ?? this.#last;
    return this.#last;
  });
}

export const summary = new Summary();
