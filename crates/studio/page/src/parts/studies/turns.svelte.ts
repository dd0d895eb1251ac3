// A long study that is asked for turn by turn: it tells how far it is, and stops between two turns or in one.

import { post } from "../../api/client";
import type { Problem, SoFar } from "../../api/types";
import { engine } from "../../state/engine.svelte";
import { server } from "../../state/server.svelte";

/** What every turn answers. */
interface Turn<T> {
  so_far: SoFar;
  done: number;
  found: T | null;
}

/** What a long run tells of how far it is. */
export interface Running {
  readonly busy: boolean;
  /** Share that is done, 0 to 1. */
  readonly done: number;
  /** What is left [s]. */
  readonly left: number | undefined;
  stop(): void;
}

export class Turns<T> {
  value = $state.raw<T>();
  problem = $state.raw<Problem>();
  busy = $state(false);
  /** Share that is done, 0 to 1. */
  done = $state(0);
  /** What is left, from what was needed so far [s]. */
  left = $state<number>();
  /** The engine file's text that the answer belongs to, and what was asked of it. */
  text = $state("");
  settings = $state.raw<object>({});
  /** The engine is another one by now. */
  readonly stale = $derived(this.text !== engine.valid);
  #count = 0;
  #asked: AbortController | undefined;

  constructor(readonly lane: string) {
    engine.whenOpened(() => this.clear());
  }

  /** All turns, one after the other; `body`: the question of a turn. */
  async run(path: string, settings: object, body: (text: string, soFar: SoFar | null) => unknown) {
    this.stop();
    const count = this.#count;
    const asked = new AbortController();
    this.#asked = asked;
    const text = engine.valid;
    const began = performance.now();
    [this.busy, this.done, this.left, this.problem] = [true, 0, undefined, undefined];
    try {
      let soFar: SoFar | null = null;
      for (;;) {
        const turn: Turn<T> = await post(path, body(text, soFar), this.lane, asked.signal);
        if (count !== this.#count) return;
        soFar = turn.so_far;
        this.done = turn.done;
        this.left = left((performance.now() - began) / 1000, turn.done);
        if (!turn.found) continue;
        [this.value, this.text, this.settings] = [turn.found, text, settings];
        return;
      }
    } catch (error) {
      if (count !== this.#count) return;
      this.problem = server.refusal(error);
      if (this.problem) this.value = undefined;
    } finally {
      if (count === this.#count) this.busy = false;
    }
  }

  /** Breaks off what is under way; an earlier answer stays. */
  stop() {
    this.#count += 1;
    this.#asked?.abort();
    this.busy = false;
  }

  clear() {
    this.stop();
    this.value = undefined;
    this.problem = undefined;
  }
}

/** What is left of a study that came so far in `seconds`. */
export function left(seconds: number, done: number): number | undefined {
  return done > 0 ? (seconds * (1 - done)) / done : undefined;
}

/** "about 3 s", "about 2 min". */
export function duration(seconds: number): string {
  if (seconds < 1) return "less than a second";
  if (seconds < 90) return `about ${Math.ceil(seconds)} s`;
  if (seconds < 90 * 60) return `about ${Math.round(seconds / 60)} min`;
  return `about ${Math.round(seconds / 3600)} h`;
}
