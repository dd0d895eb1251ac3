// A result of the server that is asked for by a button: it stays until it is asked for again.

import { post } from "../api/client";
import type { Problem } from "../api/types";
import { engine } from "./engine.svelte";
import { server } from "./server.svelte";

export class Search<T> {
  value = $state.raw<T>();
  problem = $state.raw<Problem>();
  busy = $state(false);
  /** The engine file's text that the answer belongs to, and what else was asked. */
  text = $state("");
  settings = $state.raw<Record<string, unknown>>({});
  /** The engine is another one by now. */
  readonly stale = $derived(this.text !== engine.valid);
  #count = 0;
  #asked: AbortController | undefined;

  constructor(readonly lane: string) {
    engine.whenOpened(() => this.clear());
  }

  /** Asks about the engine as it stands; an answer to an older question is dropped. */
  async ask(path: string, settings: Record<string, unknown>): Promise<T | undefined> {
    this.stop();
    const count = this.#count;
    const asked = new AbortController();
    this.#asked = asked;
    const text = engine.valid;
    this.busy = true;
    try {
      const value = await post<T>(path, { text, ...settings }, this.lane, asked.signal);
      if (count !== this.#count) return undefined;
      this.value = value;
      this.text = text;
      this.settings = settings;
      this.problem = undefined;
      return value;
    } catch (error) {
      if (count !== this.#count) return undefined;
      this.problem = server.refusal(error);
      if (this.problem) this.value = undefined;
      return undefined;
    } finally {
      if (count === this.#count) this.busy = false;
    }
  }

  /** Breaks off what is under way, here and on the server; an earlier answer stays. */
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
