// The counterweight in hand: which one, its shape while it is dragged, and a design that is looked at beside it.

import { Gone, Refused, post } from "../../api/client";
import type { CounterweightFront, Designed, Dimensions, Problem, ShapePreview } from "../../api/types";
import { engine } from "../../state/engine.svelte";
import { server } from "../../state/server.svelte";
import { Task } from "../../state/task.svelte";
import type { Key } from "./outline";

class Shaping {
  /** Name of the weight that was chosen. */
  name = $state("");
  /** Shape as it was dragged last; the file's text is that of `live`, until something else changes it. */
  live = $state.raw<ShapePreview>();
  /** Dimensions that were asked for and are not drawn yet. */
  wanted = $state.raw<Dimensions>();
  dragging = $state(false);
  /** Dimension whose handle or field is in hand. */
  held = $state<Key>();
  /** A design beside the present one. */
  ghost = $state.raw<ShapePreview>();
  problem = $state.raw<Problem>();
  readonly designs = new Task<Designed>("counterweight-design");
  readonly front = new Task<CounterweightFront>("counterweight-front");
  #busy = false;
  #looks = 0;

  choose(name: string) {
    this.name = name;
    this.live = undefined;
    this.wanted = undefined;
    this.problem = undefined;
    this.unlook();
  }

  /** The shape with these dimensions, drawn at once and written into the file. */
  async shape(dimensions: Dimensions) {
    this.wanted = dimensions;
    if (this.#busy) return;
    this.#busy = true;
    for (let asked: Dimensions | undefined = dimensions; asked; asked = this.#newer(asked)) {
      const text = engine.valid;
      const found = await this.preview(this.name, asked, "counterweight-drag", text);
      // What was undone or typed meanwhile is newer.
      if (!found || engine.text !== text) continue;
      this.live = found;
      await engine.set(found.text, `Shape of ${this.name}`, `shape ${this.name}`);
    }
    this.wanted = undefined;
    this.#busy = false;
  }

  #newer(asked: Dimensions): Dimensions | undefined {
    return this.wanted === asked ? undefined : this.wanted;
  }

  /** What a weight would be with these dimensions; `null`: as it is. */
  async preview(
    weight: string,
    dimensions: Dimensions | null,
    lane: string,
    text = engine.valid,
  ): Promise<ShapePreview | undefined> {
    // Clearances take longer than the shape: they are asked for when it rests.
    const body = { text, weight, dimensions, clearances: false };
    try {
      const found = await post<ShapePreview>("/api/counterweight/shape", body, lane);
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
