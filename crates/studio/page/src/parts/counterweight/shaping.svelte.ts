// The counterweight in hand: which one, its shape while it is dragged, and a design that is looked at beside it.

import { post } from "../../api/client";
import type { CounterweightFront, Designed, Dimensions, Problem, ShapePreview } from "../../api/types";
import { engine } from "../../state/engine.svelte";
import { server } from "../../state/server.svelte";
import { Search } from "../../state/search.svelte";
import type { Key } from "./shape/outline";

/** Something that belongs to one weight. */
interface Of<T> {
  weight: string;
  is: T;
}

class Shaping {
  /** Weights that stand in the file one by one can be shaped; from the free end on. */
  readonly weights = $derived(
    (engine.summary?.counterweights ?? []).filter((one) => one.path !== null).toSorted((a, b) => a.z - b.z),
  );
  #picked = $state("");
  /** The weight in hand. */
  readonly chosen = $derived(this.weights.find((one) => one.name === this.#picked) ?? this.weights[0]);
  readonly name = $derived(this.chosen?.name ?? "");
  dragging = $state(false);
  /** Dimension whose handle or field is in hand. */
  held = $state<Key>();

  #live = $state.raw<Of<ShapePreview>>();
  #wanted = $state.raw<Of<Dimensions>>();
  #ghost = $state.raw<Of<ShapePreview>>();
  #refused = $state.raw<Of<Problem> & { text: string }>();
  /** Shape as it was dragged last, until something else changes the text. */
  readonly live = $derived.by(() => {
    const shape = this.#own(this.#live);
    return shape && (this.dragging || shape.text === engine.text) ? shape : undefined;
  });
  /** Dimensions that were asked for and are not drawn yet. */
  readonly wanted = $derived(this.#own(this.#wanted));
  /** A design beside the present one. */
  readonly ghost = $derived(this.#own(this.#ghost));
  /** Why the shape that was asked for is none. */
  readonly problem = $derived(this.#refused?.text === engine.valid ? this.#own(this.#refused) : undefined);

  readonly designs = new Search<Designed>("counterweight-design");
  readonly front = new Search<CounterweightFront>("counterweight-front");
  #busy = false;
  #looks = 0;

  constructor() {
    engine.whenOpened(() => this.choose(""));
  }

  /** What belongs to the weight in hand. */
  #own<T>(of: Of<T> | undefined): T | undefined {
    return of?.weight === this.name ? of.is : undefined;
  }

  choose(name: string) {
    this.#picked = name;
    this.unlook();
  }

  /** The shape with these dimensions, drawn at once and written into the file. */
  async shape(dimensions: Dimensions) {
    this.#wanted = { weight: this.name, is: dimensions };
    if (this.#busy) return;
    this.#busy = true;
    try {
      for (let asked: Of<Dimensions> | undefined = this.#wanted; asked; asked = this.#newer(asked))
        await this.#write(asked);
    } finally {
      this.#wanted = undefined;
      this.#busy = false;
    }
  }

  async #write({ weight, is }: Of<Dimensions>) {
    const text = engine.valid;
    const found = await this.#preview(weight, is, "counterweight-drag", text);
    // What was undone or typed meanwhile is newer.
    if (!found || engine.text !== text) return;
    this.#refused = undefined;
    this.#live = { weight, is: found };
    await engine.set(found.text, `Shape of ${weight}`, `shape ${weight}`);
  }

  #newer(asked: Of<Dimensions>): Of<Dimensions> | undefined {
    return this.#wanted === asked ? undefined : this.#wanted;
  }

  /** What a weight would be with these dimensions. */
  async #preview(
    weight: string,
    dimensions: Dimensions,
    lane: string,
    text: string,
    wanted = () => true,
  ): Promise<ShapePreview | undefined> {
    // Clearances take longer than the shape: they are asked for when it rests.
    const body = { text, weight, dimensions, clearances: false };
    try {
      return await post<ShapePreview>("/api/counterweight/shape", body, lane);
    } catch (error) {
      const refused = server.refusal(error);
      if (refused && wanted()) this.#refused = { weight, is: refused, text };
      return undefined;
    }
  }

  /** Draws a design over the present shape. */
  async look(dimensions: Dimensions) {
    const look = ++this.#looks;
    const weight = this.name;
    const newest = () => look === this.#looks;
    const found = await this.#preview(weight, dimensions, "counterweight-ghost", engine.valid, newest);
    if (newest()) this.#ghost = found && { weight, is: found };
  }

  /** Takes that design away again, even if it is still on its way. */
  unlook() {
    this.#looks += 1;
    this.#ghost = undefined;
  }

  /** Gives these dimensions to several weights, as one step. */
  async adopt(names: readonly string[], dimensions: Dimensions, what: string) {
    const before = engine.valid;
    let text = before;
    for (const name of names) {
      const found = await this.#preview(name, dimensions, "counterweight-adopt", text);
      if (!found) return;
      text = found.text;
    }
    // What was typed meanwhile is newer.
    if (engine.text !== before) return;
    this.unlook();
    await engine.set(text, what);
  }
}

export const shaping = new Shaping();
