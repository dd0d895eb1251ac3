// A result of the server that follows what it is asked for.

import { post } from "../api/client";
import type { Problem } from "../api/types";
import { server } from "./server.svelte";

/** What is asked: `null` asks nothing. */
export type Question = { path: string; body: unknown } | null;

/**
 * Asks again whenever the question changes, one request at a time: while one is under way only the newest question
 * waits. The last answer stays until the next is there, so that nothing jumps.
 */
export class Resource<T> {
  value = $state.raw<T>();
  problem = $state.raw<Problem>();
  busy = $state(false);
  #next: Question | undefined;
  #asked = "";

  constructor(
    readonly lane: string,
    /** `undefined` leaves the last question and its answer. */
    question: () => Question | undefined,
  ) {
    $effect(() => {
      // A server that came back is asked again.
      void server.epoch;
      const next = question();
      if (next === undefined) return;
      const key = JSON.stringify(next) + server.epoch;
      if (key === this.#asked) return;
      this.#asked = key;
      this.#next = next;
      void this.#run();
    });
  }

  async #run() {
    if (this.busy) return;
    this.busy = true;
    // Nothing may be awaited between the last look for a question and the end of being busy: one could be lost there.
    try {
      while (this.#next !== undefined) await this.#ask(this.#next);
    } finally {
      this.busy = false;
    }
  }

  async #ask(question: Question) {
    this.#next = undefined;
    if (question === null) {
      this.value = undefined;
      this.problem = undefined;
      return;
    }
    try {
      this.value = await post<T>(question.path, question.body, this.lane);
      this.problem = undefined;
    } catch (error) {
      const refused = server.refusal(error);
      if (!refused) return;
      this.problem = refused;
      this.value = undefined;
    }
  }
}
