// Loads of the engine and of the first pinned state at the speed in view: asked for once, shown in many places.

import type { Loads } from "../api/types";
import { engine } from "./engine.svelte";
import { Resource } from "./resource.svelte";
import { view } from "./view.svelte";

/** An angle for each degree: what curves show, at half the size of what `lanchester loads` writes. */
const SAMPLES = 360;

function body(text: string) {
  return { text, samples: SAMPLES, ...(view.speed === undefined ? {} : { speed: view.speed }) };
}

class SharedLoads {
  now!: Resource<Loads>;
  /** Of the first pin, to compare with; nothing without a pin. */
  before!: Resource<Loads>;

  constructor() {
    $effect.root(() => {
      this.now = new Resource<Loads>("loads", () =>
        engine.valid === "" ? null : { path: "/api/loads", body: body(engine.valid) },
      );
      this.before = new Resource<Loads>("loads-of-pin", () => {
        const pin = view.pins[0];
        return pin ? { path: "/api/loads", body: body(pin.text) } : null;
      });
    });
  }
}

export const loads = new SharedLoads();
