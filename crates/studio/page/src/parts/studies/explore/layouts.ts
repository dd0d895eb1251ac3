// What a search over layouts varies, and what of its answer is drawn.

import type { LayoutRow } from "../../../api/types";
import type { Measure } from "../../../state/units.svelte";

/** What layouts may be judged by, as the server reads it, and in what it is measured. */
export const OBJECTIVES: readonly (readonly [string, Measure])[] = [
  ["force order 1", "force"],
  ["couple order 1", "moment"],
  ["force order 2", "force"],
  ["couple order 2", "moment"],
  ["roll moment order 1", "moment"],
  ["roll moment order 2", "moment"],
  ["bending moment", "moment"],
  ["main load", "force"],
  ["uneven firing", "angle"],
  ["neighbours", "none"],
  ["length", "length"],
  ["counterweights", "unbalance"],
];

export const USUAL = ["force order 1", "couple order 1", "force order 2", "couple order 2"];
export const FIRING = ["uneven firing", "neighbours"];

/** Most values of one list. */
const MOST = 1000;

/**
 * Degrees as typed, as radians: a list `60, 90`, a range `60..120 by 15`, or both. Nothing: `null`; what cannot be read:
 * `undefined`.
 */
export function angles(text: string): number[] | null | undefined {
  if (text.trim() === "") return null;
  const degrees: number[] = [];
  for (const part of text.split(",")) {
    const range = /^\s*(-?[\d.]+)\s*(?:\.\.|to)\s*(-?[\d.]+)\s*by\s*([\d.]+)\s*$/.exec(part);
    if (!range) {
      if (part.trim() === "" || !Number.isFinite(Number(part))) return undefined;
      degrees.push(Number(part));
      continue;
    }
    const [from, to, step] = range.slice(1).map(Number) as [number, number, number];
    const steps = (to - from) / step;
    if (!(steps >= 0 && steps <= MOST)) return undefined;
    for (let count = 0; count <= steps + 1e-9; count++) degrees.push(from + count * step);
  }
  return degrees.map((angle) => (angle * Math.PI) / 180);
}

export const degrees = (angle: number) => Math.round((1e6 * angle * 180) / Math.PI) / 1e6;

/** "0 180 180 0". */
export function throwsOf({ throws }: LayoutRow): string {
  return throws.map(degrees).join(" ");
}

export function firingOf({ firing_order: order }: LayoutRow): string {
  return order?.join("-") ?? "";
}

/** The layouts by one of their objectives, or by their number where there is none. */
export function sorted(rows: readonly LayoutRow[], by: number | undefined, falling: boolean): LayoutRow[] {
  const key = (row: LayoutRow) => (by === undefined ? row.number : (row.values[by] ?? 0));
  const sign = falling ? -1 : 1;
  return rows.toSorted((a, b) => sign * (key(a) - key(b)) || a.number - b.number);
}

/** Of points in a plane those that no other one beats in both: by rising x, each with its place. */
export function frontOf(points: readonly (readonly [number, number])[]): number[] {
  const order = points.map((_, place) => place);
  order.sort((a, b) => points[a]![0] - points[b]![0] || points[a]![1] - points[b]![1]);
  const front: number[] = [];
  let least = Infinity;
  for (const place of order) {
    const y = points[place]![1];
    if (y >= least) continue;
    least = y;
    front.push(place);
  }
  return front;
}

/** The steps that bound what a front leaves out: from each of its points straight on, then down to the next. */
export function steps(front: readonly (readonly [number, number])[]): { x: number[]; y: number[] } {
  const [x, y]: [number[], number[]] = [[], []];
  front.forEach(([px, py], index) => {
    const before = front[index - 1];
    if (before) {
      x.push(px);
      y.push(before[1]);
    }
    x.push(px);
    y.push(py);
  });
  return { x, y };
}
