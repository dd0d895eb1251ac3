// Which numbers of the form have their sliders out, and the engine that they started from.

import { SvelteMap } from "svelte/reactivity";
import { engine } from "../../../state/engine.svelte";
import type { Watched } from "./curves";
import type { Span } from "./slide";

class Slides {
  /** By the path of the key: how far each of its numbers goes. It stays while a number is slid. */
  readonly open = new SvelteMap<string, Span[]>();
  /** The one that was moved or opened last: the curve stands below it. */
  active = $state<string>();
  /** Text of the engine before: the ghost of the curves. */
  before = $state("");
  /** The curve that was chosen; none: what the number acts on first. */
  watched = $state<Watched>();

  constructor() {
    engine.whenOpened(() => {
      this.open.clear();
      this.active = undefined;
      this.before = "";
      this.watched = undefined;
    });
  }

  show(path: string, spans: Span[]) {
    if (this.open.size === 0) this.mark();
    this.open.set(path, spans);
    this.active = path;
  }

  hide(path: string) {
    this.open.delete(path);
    if (this.active === path) this.active = [...this.open.keys()].at(-1);
  }

  /** From now on the curves are compared with this engine. */
  mark() {
    this.before = engine.valid;
  }
}

export const slides = new Slides();
