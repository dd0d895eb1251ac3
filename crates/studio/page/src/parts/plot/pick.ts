// What the readout tells: the samples next to a place.

import { place, type PixelMap } from "./scale";
import type { Series, Values } from "./series";

/** Index of the value next to `value` in rising values. */
export function nearest(values: Values, value: number): number {
  let [low, high] = [0, values.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((values[middle] as number) <= value) low = middle;
    else high = middle;
  }
  const last = Math.max(high, 0);
  return Math.abs((values[last] as number) - value) < Math.abs((values[low] as number) - value) ? last : low;
}

/** A sample: which series, and which of its points. */
export interface Sample {
  series: number;
  index: number;
}

/** The point next to a place on the screen, farther than `reach` px not. */
export function pointAt(
  series: readonly Series[],
  mapX: PixelMap,
  mapY: PixelMap,
  [px, py]: [number, number],
  reach = Infinity,
): Sample | undefined {
  let best: Sample | undefined;
  let least = reach * reach;
  for (const [which, one] of series.entries()) {
    const count = Math.min(one.x.length, one.y.length);
    for (let i = 0; i < count; i++) {
      const dx = place(mapX, one.x[i] as number) - px;
      const dy = place(mapY, one.y[i] as number) - py;
      const distance = dx * dx + dy * dy;
      if (distance < least) {
        least = distance;
        best = { series: which, index: i };
      }
    }
  }
  return best;
}

/** All places of series that share an axis, rising and each once: what arrow keys walk through. */
export function places(series: readonly Series[]): Values {
  const first = series[0]?.x;
  if (first && series.every((one) => one.x === first)) return first;
  return Float64Array.from(new Set(series.flatMap((one) => Array.from(one.x)))).sort();
}

/** Whether any value is larger than rounding noise. */
export function matters(values: Values, noise: number): boolean {
  for (let i = 0; i < values.length; i++) if (Math.abs(values[i] as number) > noise) return true;
  return false;
}
