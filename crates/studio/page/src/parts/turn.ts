// The crank angle of the whole studio, inside the period of a result.

import { engine } from "../state/engine.svelte";
import { view } from "../state/view.svelte";
import type { Cursor } from "./plot/series";

export function turned(period: number): Cursor {
  const value = view.theta % period;
  return { value: value < 0 ? value + period : value, set: (theta) => (view.theta = theta) };
}

/** Whether the engine turns the other way: seen from the free end y then points to the left. */
export function mirrored(): boolean {
  return engine.value("rotation") === "reverse";
}
