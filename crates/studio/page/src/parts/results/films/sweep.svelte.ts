// Oil films at one speed after the other: asked for by a button, kept while other tabs are open.

import { post } from "../../../api/client";
import type { BearingFilms, Cavitation, Problem } from "../../../api/types";
import { engine } from "../../../state/engine.svelte";
import { server } from "../../../state/server.svelte";
import { left, type Running } from "../../studies/turns.svelte";

type Model = "file" | Cavitation;

export class Sweep implements Running {
  /** By speed, rising: those that were reached. */
  answers = $state.raw<readonly BearingFilms[]>([]);
  /** All that were asked for [rad/s]. */
  speeds = $state.raw<readonly number[]>([]);
  problem = $state.raw<Problem>();
  busy = $state(false);
  /** What is left, from what was needed so far [s]. */
  left = $state<number>();
  /** The engine file's text and the model of cavitation that the answers belong to. */
  text = $state("");
  model = $state<Model>("file");
  readonly done = $derived(this.speeds.length > 0 ? this.answers.length / this.speeds.length : 0);
  #count = 0;
  #asked: AbortController | undefined;

  constructor(readonly lane = "films-over-speed") {
    engine.whenOpened(() => this.clear());
  }

  isStale(model: Model): boolean {
    return this.text !== engine.valid || this.model !== model;
  }

  async run(speeds: readonly number[], model: Model) {
    this.clear();
    const count = this.#count;
    const asked = new AbortController();
    this.#asked = asked;
    const text = engine.valid;
    const models = model === "file" ? {} : { models: [model] };
    const began = performance.now();
    [this.busy, this.speeds, this.text, this.model] = [true, speeds, text, model];
    try {
      for (const speed of speeds) {
        const answer = await post<BearingFilms>(
          "/api/films",
          { text, speed, ...models },
          this.lane,
          asked.signal,
        );
        if (count !== this.#count) return;
        this.answers = [...this.answers, answer];
        this.left = left((performance.now() - began) / 1000, this.done);
      }
    } catch (error) {
      if (count === this.#count) this.problem = server.refusal(error);
    } finally {
      if (count === this.#count) this.busy = false;
    }
  }

  /** Ends what is under way; the speeds that were reached stay. */
  stop() {
    this.#count += 1;
    this.#asked?.abort();
    this.busy = false;
  }

  clear() {
    this.stop();
    this.answers = [];
    this.speeds = [];
    this.left = undefined;
    this.problem = undefined;
  }
}

export const sweep = new Sweep();
