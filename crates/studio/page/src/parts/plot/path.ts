// Outlines of series as words of SVG, made in one pass; places are rounded to a tenth of a pixel.

import { place, type PixelMap } from "./scale";
import type { Values } from "./series";

/** Farther out than this a browser's own arithmetic goes astray [px]. */
const FAR = 20000;

function tenth(pixel: number): number {
  return Math.round((pixel > FAR ? FAR : pixel < -FAR ? -FAR : pixel) * 10) / 10;
}

/** A line through the points; where a value is not finite it breaks. */
export function linePath(x: Values, y: Values, mapX: PixelMap, mapY: PixelMap, closed = false): string {
  const count = Math.min(x.length, y.length);
  const straight = !mapX.log && !mapY.log;
  let path = "";
  let drawing = false;
  let [lastX, lastY] = [NaN, NaN];
  for (let i = 0; i < count; i++) {
    const px = straight ? mapX.scale * (x[i] as number) + mapX.shift : place(mapX, x[i] as number);
    const py = straight ? mapY.scale * (y[i] as number) + mapY.shift : place(mapY, y[i] as number);
    if (px - px !== 0 || py - py !== 0) {
      drawing = false;
      continue;
    }
    const [left, top] = [tenth(px), tenth(py)];
    if (drawing && left === lastX && top === lastY) continue;
    path += (drawing ? "L" : "M") + left + " " + top;
    drawing = true;
    lastX = left;
    lastY = top;
  }
  return closed && path !== "" ? path + "Z" : path;
}

/** The area between two curves over the same x. */
export function areaPath(
  x: Values,
  y: Values,
  base: Values | undefined,
  mapX: PixelMap,
  mapY: PixelMap,
): string {
  const count = Math.min(x.length, y.length);
  let there = "";
  let back = "";
  for (let i = 0; i < count; i++) {
    const px = tenth(place(mapX, x[i] as number));
    const upper = tenth(place(mapY, y[i] as number));
    const lower = tenth(place(mapY, base ? (base[i] as number) : 0));
    if (px - px !== 0 || upper - upper !== 0 || lower - lower !== 0) continue;
    there += (there === "" ? "M" : "L") + px + " " + upper;
    back = "L" + px + " " + lower + back;
  }
  return there === "" ? "" : there + back + "Z";
}

/** Bars on zero, `width` px wide with their middles `offset` px beside their places. */
export function barsPath(
  x: Values,
  y: Values,
  mapX: PixelMap,
  mapY: PixelMap,
  width: number,
  offset: number,
): string {
  const count = Math.min(x.length, y.length);
  const foot = tenth(place(mapY, 0));
  let path = "";
  for (let i = 0; i < count; i++) {
    const left = tenth(place(mapX, x[i] as number) + offset - width / 2);
    const top = tenth(place(mapY, y[i] as number));
    if (left - left !== 0 || top - top !== 0 || top === foot) continue;
    path += `M${left} ${foot}V${top}h${tenth(width)}V${foot}Z`;
  }
  return path;
}

/** Dots of radius `r` px. */
export function dotsPath(x: Values, y: Values, mapX: PixelMap, mapY: PixelMap, r: number): string {
  const count = Math.min(x.length, y.length);
  let path = "";
  for (let i = 0; i < count; i++) {
    const [px, py] = [place(mapX, x[i] as number), place(mapY, y[i] as number)];
    if (px - px !== 0 || py - py !== 0) continue;
    path += `M${tenth(px - r)} ${tenth(py)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
  }
  return path;
}

/** The head of an arrow along the last stretch, `long` px; shorter arrows have shorter heads. */
export function headPath(x: Values, y: Values, mapX: PixelMap, mapY: PixelMap, long: number): string {
  const last = Math.min(x.length, y.length) - 1;
  if (last < 1) return "";
  const [px, py] = [place(mapX, x[last] as number), place(mapY, y[last] as number)];
  const dx = px - place(mapX, x[last - 1] as number);
  const dy = py - place(mapY, y[last - 1] as number);
  const length = Math.hypot(dx, dy);
  if (!(length > 1)) return "";
  const size = Math.min(long, 0.6 * length) / length;
  const corner = (side: number) =>
    `${tenth(px - size * (dx + side * 0.4 * dy))} ${tenth(py - size * (dy - side * 0.4 * dx))}`;
  return `M${tenth(px)} ${tenth(py)}L${corner(1)}L${corner(-1)}Z`;
}

/** The least distance between neighbours of all places together; infinite for a single one. */
export function spacing(all: readonly Values[]): number {
  const places = [...new Set(all.flatMap((values) => Array.from(values)))].sort((a, b) => a - b);
  let least = Infinity;
  for (let i = 1; i < places.length; i++) {
    const gap = (places[i] as number) - (places[i - 1] as number);
    if (gap > 1e-9) least = Math.min(least, gap);
  }
  return least;
}
