// The counterweight in hand: which one, its shape while it is dragged, and a design that is looked at beside it.

import { Gone, Refused, post } from "../../api/client";
import type { CounterweightFront, DesignAnswer, Dimensions, Problem, ShapePreview } from "../../api/types";
import { engine } from "../../state/engine.svelte";
import { server } from "../../state/server.svelte";
import { Task } from "../../state/task.svelte";
import type { Key } from "./outline";

class Shaping {
  /** Name of the weight that was chosen. */
  name = $state("");
  /** Shape while it is dragged; the file's follows it. */
  live = $state.raw<ShapePreview>();
  dragging = $state(false);
  /** Dimension whose handle or field is in hand. */
  held = $state<Key>();
  /** A design beside the present one. */
  ghost = $state.raw<ShapePreview>();
  problem = $state.raw<Problem>();
  readonly designs = new Task<DesignAnswer>("counterweight-design");
  readonly front = new Task<CounterweightFront>("counterweight-front");
  #wanted: Dimensions | undefined;
  #busy = false;
  #looks = 0;

  choose(name: string) {
    this.name = name;
    this.live = undefined;
    this.problem = undefined;
    this.unlook();
  }

  /** The shape with these dimensions, drawn at once and written into the file. */
  async shape(dimensions: Dimensions) {
    this.#wanted = dimensions;
    if (this.#busy) return;
    this.#busy = true;
    while (this.#wanted) {
      const asked = this.#wanted;
      this.#wanted = undefined;
      const found = await this.preview(this.name, asked, "counterweight-drag");
      if (!found) continue;
      this.live = found;
      await engine.set(found.text, `Shape of ${this.name}`, `shape ${this.name}`);
    }
    this.#busy = false;
  }

  /** What a weight would be with these dimensions; `null`: as it is. */
  async preview(
    weight: string,
    dimensions: Dimensions | null,
    lane: string,
    text = engine.valid,
  ): Promise<ShapePreview | undefined> {
    try {
      const found = await post<ShapePreview>("/api/counterweight/shape", { text, weight, dimensions }, lane);
      this.problem = undefined;
      return found;
    } catch (error) {
      if (error instanceof Refused) this.problem = error.problem;
      else if (error instanceof Gone) server.lost();
      else throw error;
      return undefined;
    }
  }

  /** Draws a design over the present shape. */
  async look(dimensions: Dimensions) {
    const look = ++this.#looks;
    const found = await this.preview(this.name, dimensions, "counterweight-ghost");
    if (look === this.#looks) this.ghost = found;
  }

  /** Takes that design away again, even if it is still on its way. */
  unlook() {
    this.#looks += 1;
    this.ghost = undefined;
  }

  /** Gives these dimensions to several weights, as one step. */
  async adopt(names: readonly string[], dimensions: Dimensions, what: string) {
    let text = engine.valid;
    for (const name of names) {
      const found = await this.preview(name, dimensions, "counterweight-adopt", text);
      if (!found) return;
      text = found.text;
    }
    this.unlook();
    await engine.set(text, what);
  }
}

export const shaping = new Shaping();
