// Loads of the engine and of the first pinned state at the speed in view: asked for once, shown in many places.

import { untrack } from "svelte";
import type { Loads } from "../api/types";
import { engine } from "./engine.svelte";
import { Resource, type Question } from "./resource.svelte";
import { view } from "./view.svelte";

/** An angle for each degree: what curves show, at half the size of what `lanchester loads` writes. */
const SAMPLES = 360;

/** What is asked for the loads of an engine at the speed in view; curves of the whole engine alone make a short answer. */
export function ofLoads(text: string, curves: "whole" | "all" = "whole"): Question {
  const speed = view.speed === undefined ? {} : { speed: view.speed };
  return { path: "/api/loads", body: { text, samples: SAMPLES, curves, ...speed } };
}

class SharedLoads {
  now!: Resource<Loads>;
  /** Of the first pin, to compare with; nothing without a pin. */
  before!: Resource<Loads>;
  /** How many look at curves of parts, of cylinders or of pistons. */
  #watchers = $state(0);

  constructor() {
    $effect.root(() => {
      this.now = new Resource<Loads>("loads", () =>
        engine.valid === "" ? null : ofLoads(engine.valid, this.#watchers > 0 ? "all" : "whole"),
      );
      this.before = new Resource<Loads>("loads-of-pin", () => {
        const pin = view.pins[0];
        return pin ? ofLoads(pin.text) : null;
      });
    });
  }

  /** All curves are wanted until what it returns is called; for effects. */
  watch(): () => void {
    untrack(() => this.#watchers++);
    return () => this.#watchers--;
  }
}

export const loads = new SharedLoads();
