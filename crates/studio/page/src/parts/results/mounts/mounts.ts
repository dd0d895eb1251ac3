// What the mounts carry over speed, as series.

import type { MountStudy } from "../../../api/types";
import { orderTitle } from "../../order";
import type { Series } from "../../plot/series";

type Complex = readonly [number, number];

/** Orders drawn one by one beside the largest force. */
const DRAWN = 5;
/** Orders that stay below this share of the largest force are left out. */
const FLAT = 1e-3;

/**
 * Largest size of a vector `Re(V e^{ia})` over a: the major half axis of its ellipse.
 * `|Re(V e^{ia})|² = (|V|² + Re(V·V e^{2ia})) / 2`
 */
export function amplitude(vector: readonly Complex[]): number {
  let [size, re, im] = [0, 0, 0];
  for (const [a, b] of vector) {
    size += a * a + b * b;
    re += a * a - b * b;
    im += 2 * a * b;
  }
  return Math.sqrt((size + Math.hypot(re, im)) / 2);
}

/** The largest force at a mount over speed, then its largest orders. */
export function forces(study: MountStudy, mount: number): Series[] {
  const { speeds } = study.response;
  const x = speeds.map((one) => one.speed);
  const peaks = speeds.map((one) => one.peaks[mount]?.value ?? NaN);
  const most = Math.max(0, ...speeds.flatMap((one) => one.peaks.map((peak) => peak.value)));
  const orders = [...new Set(speeds.flatMap((one) => one.orders.map(({ order }) => order)))].sort(
    (a, b) => a - b,
  );
  const curves = orders
    .map((order) => {
      const y = speeds.map((one) => {
        const found = one.orders.find((other) => other.order === order)?.forces[mount];
        return found ? amplitude(found) : 0;
      });
      return { order, y, most: Math.max(0, ...y) };
    })
    .filter((curve) => curve.most > FLAT * most)
    .sort((a, b) => b.most - a.most)
    .slice(0, DRAWN)
    .sort((a, b) => a.order - b.order);
  return [
    { name: "largest", x, y: peaks, colour: 1, width: 2.25 },
    ...curves.map(({ order, y }, index) => ({
      name: orderTitle(order),
      x,
      y,
      colour: index + 2,
      width: 1.5,
    })),
  ];
}

/** The largest force of each order at any mount over speed. */
export function orderMap({ response: { speeds } }: MountStudy): {
  speeds: number[];
  orders: number[];
  values: number[][];
} {
  const orders = [...new Set(speeds.flatMap((one) => one.orders.map(({ order }) => order)))].sort(
    (a, b) => a - b,
  );
  const values = orders.map((order) =>
    speeds.map((one) =>
      Math.max(0, ...(one.orders.find((other) => other.order === order)?.forces ?? []).map(amplitude)),
    ),
  );
  return { speeds: speeds.map((one) => one.speed), orders, values };
}
