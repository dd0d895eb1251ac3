// Films with the grooves of the file: solved at every instant, so that they are asked for by a button.

import { post } from "../../../api/client";
import type { BearingFilms, Problem } from "../../../api/types";
import { engine } from "../../../state/engine.svelte";
import { server } from "../../../state/server.svelte";

export class Grooved {
  problem = $state.raw<Problem>();
  busy = $state(false);
  #answer = $state.raw<{ question: string; films: BearingFilms }>();
  #count = 0;
  #asked: AbortController | undefined;

  constructor(readonly lane = "films-with-grooves") {
    engine.whenOpened(() => this.clear());
  }

  /** The films with grooves of this question without them, where they are known. */
  of(question: object | null): BearingFilms | undefined {
    return this.#answer?.question === JSON.stringify(question) ? this.#answer?.films : undefined;
  }

  async run(question: object) {
    this.clear();
    const count = this.#count;
    const asked = new AbortController();
    this.#asked = asked;
    this.busy = true;
    try {
      const body = { ...question, grooves: true };
      const films = await post<BearingFilms>("/api/films", body, this.lane, asked.signal);
      if (count === this.#count) this.#answer = { question: JSON.stringify(question), films };
    } catch (error) {
      if (count === this.#count) this.problem = server.refusal(error);
    } finally {
      if (count === this.#count) this.busy = false;
    }
  }

  /** Ends what is under way and forgets what was found. */
  clear() {
    this.#count += 1;
    this.#asked?.abort();
    this.busy = false;
    this.#answer = undefined;
    this.problem = undefined;
  }
}

export const grooved = new Grooved();
