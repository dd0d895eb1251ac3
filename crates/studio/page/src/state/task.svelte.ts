// A result of the server that is asked for by a button: it stays until it is asked for again.

import { Gone, Refused, post } from "../api/client";
import type { Problem } from "../api/types";
import { server } from "./server.svelte";

export class Task<T> {
  value = $state.raw<T>();
  problem = $state.raw<Problem>();
  busy = $state(false);
  /** The engine file's text that the answer belongs to. */
  text = $state("");
  #count = 0;
  #asked: AbortController | undefined;

  constructor(readonly lane: string) {}

  /** Asks anew; an answer to an older question is dropped. */
  async ask(path: string, text: string, settings: Record<string, unknown>): Promise<T | undefined> {
    this.stop();
    const count = this.#count;
    const asked = new AbortController();
    this.#asked = asked;
    this.busy = true;
    try {
      const value = await post<T>(path, { text, ...settings }, this.lane, asked.signal);
      if (count !== this.#count) return undefined;
      this.value = value;
      this.text = text;
      this.problem = undefined;
      return value;
    } catch (error) {
      if (count !== this.#count) return undefined;
      if (error instanceof Refused) {
        this.problem = error.problem;
        this.value = undefined;
      } else if (error instanceof Gone) server.lost();
      else throw error;
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
