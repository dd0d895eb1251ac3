// The part of a plot that is looked at, in SI values.

import { place, valueAt, type PixelMap, type Range } from "./scale";

export interface Zoom {
  x: Range;
  y: Range;
}

/** Narrower than this share of the whole nothing is shown: digits run out. */
const NARROWEST = 1e-6;

/** Zoomed about a point on the screen: `factor` < 1 shows less. */
export function about(
  maps: [PixelMap, PixelMap],
  shown: Zoom,
  [px, py]: [number, number],
  factor: number,
): Zoom {
  const one = (map: PixelMap, range: Range, pixel: number): Range => {
    const [a, b] = [place(map, range[0]), place(map, range[1])];
    return [valueAt(map, pixel + (a - pixel) * factor), valueAt(map, pixel + (b - pixel) * factor)];
  };
  return { x: one(maps[0], shown.x, px), y: one(maps[1], shown.y, py) };
}

/** Moved by so many pixels. */
export function moved(maps: [PixelMap, PixelMap], shown: Zoom, [dx, dy]: [number, number]): Zoom {
  const one = (map: PixelMap, range: Range, by: number): Range => [
    valueAt(map, place(map, range[0]) - by),
    valueAt(map, place(map, range[1]) - by),
  ];
  return { x: one(maps[0], shown.x, dx), y: one(maps[1], shown.y, dy) };
}

/** What is left of a wish inside the whole; `undefined`: all of it is shown. */
export function within(wish: Zoom, whole: Zoom): Zoom | undefined {
  const one = (range: Range, all: Range): Range => {
    const span = all[1] - all[0];
    const least = span * NARROWEST;
    let [low, high] = range;
    if (high - low < least) [low, high] = [(low + high - least) / 2, (low + high + least) / 2];
    if (high - low >= span) return all;
    if (low < all[0]) return [all[0], all[0] + (high - low)];
    if (high > all[1]) return [all[1] - (high - low), all[1]];
    return [low, high];
  };
  const x = one(wish.x, whole.x);
  const y = one(wish.y, whole.y);
  const same = (a: Range, b: Range) =>
    Math.abs(a[0] - b[0]) + Math.abs(a[1] - b[1]) < 1e-9 * (Math.abs(b[1] - b[0]) || 1);
  return same(x, whole.x) && same(y, whole.y) ? undefined : { x, y };
}

/** From a box on the screen; a flat or narrow one zooms along its length alone. */
export function boxed(
  maps: [PixelMap, PixelMap],
  shown: Zoom,
  from: [number, number],
  to: [number, number],
  equal: boolean,
): Zoom | undefined {
  const [width, height] = [Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1])];
  if (Math.max(width, height) < 6) return undefined;
  const one = (map: PixelMap, a: number, b: number): Range => {
    const [p, q] = [valueAt(map, a), valueAt(map, b)];
    return p < q ? [p, q] : [q, p];
  };
  const flat = !equal && height < 0.2 * width;
  const narrow = !equal && width < 0.2 * height;
  return {
    x: narrow ? shown.x : one(maps[0], from[0], to[0]),
    y: flat ? shown.y : one(maps[1], from[1], to[1]),
  };
}
