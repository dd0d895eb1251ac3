// How the block moves on its mounts, put together from the orders of the answer.

import type { MountStudy, SpeedResponse } from "../../../api/types";
import { orderTitle } from "../../order";
import type { Series } from "../../plot/series";
import { MOTIONS } from "../forces/directions";
import { amplitude } from "./mounts";

type Complex = readonly [number, number];

/** Angles of a revolution at which the orders are added up. */
const ANGLES = 360;
/** Revolutions after which orders repeat, at most: gears of more teeth than that are cut off there. */
const LONGEST = 64;
/** Ellipses of single orders drawn beside the whole orbit, and those too small to be seen. */
const DRAWN = 3;
const FLAT = 0.02;

/** A direction of looking: what of a displacement goes to the right and what up. */
export const VIEWS = {
  front: { name: "From the free end", right: 1, up: 0 },
  side: { name: "From the side", right: 2, up: 0 },
  top: { name: "From above", right: 2, up: 1 },
} as const;
export type Seen = keyof typeof VIEWS;

/** The answer at the computed speed next to a wanted one; its place in the list. */
export function nextSpeed(study: MountStudy, wanted: number | undefined): number {
  const speeds = study.response.speeds.map((one) => one.speed);
  if (wanted === undefined) return speeds.length - 1;
  const far = speeds.map((speed) => Math.abs(speed - wanted));
  return far.indexOf(Math.min(...far));
}

/** Smallest number of revolutions after which all orders repeat. */
export function revolutions(orders: readonly number[]): number {
  const whole = (value: number) => Math.abs(value - Math.round(value)) < 1e-6;
  for (let count = 1; count < LONGEST; count++) {
    if (orders.every((order) => whole(count * order))) return count;
  }
  return LONGEST;
}

/** Crank angles over the period of a response [rad]; the end is left out. */
export function anglesOf(response: SpeedResponse): Float64Array {
  const count = ANGLES * revolutions(response.orders.map(({ order }) => order));
  return Float64Array.from({ length: count }, (_, index) => (2 * Math.PI * index) / ANGLES);
}

/** `SUM of Re(V e^{i n theta})` over the orders. */
export function summed(
  parts: readonly { order: number; value: Complex }[],
  angles: ArrayLike<number>,
): Float64Array {
  const out = new Float64Array(angles.length);
  for (const { order, value } of parts) {
    for (let i = 0; i < out.length; i++) {
      const angle = order * (angles[i] as number);
      out[i] = (out[i] as number) + value[0] * Math.cos(angle) - value[1] * Math.sin(angle);
    }
  }
  return out;
}

/** A coordinate of the centre over the angles. */
function coordinate(response: SpeedResponse, which: number, angles: Float64Array): Float64Array {
  return summed(
    response.orders.map(({ order, motion }) => ({ order, value: motion[which] ?? [0, 0] })),
    angles,
  );
}

/** Displacement (`first` 0) or rotation (`first` 3) of the block's centre over the crank angle. */
export function overAngle(response: SpeedResponse, first: 0 | 3): Series[] {
  const x = anglesOf(response);
  return [0, 1, 2].map((index) => ({
    name: MOTIONS[first + index] ?? "",
    x,
    y: coordinate(response, first + index, x),
    colour: index + 1,
  }));
}

/** Half of what each coordinate goes to and fro, over speed. */
export function overSpeed(study: MountStudy, first: 0 | 3): Series[] {
  const { speeds } = study.response;
  const x = speeds.map((one) => one.speed);
  const angles = speeds.map(anglesOf);
  return [0, 1, 2].map((index) => ({
    name: MOTIONS[first + index] ?? "",
    x,
    y: speeds.map((one, place) => {
      const values = coordinate(one, first + index, angles[place] as Float64Array);
      let [low, high] = [Infinity, -Infinity];
      for (const value of values) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
      return (high - low) / 2;
    }),
    colour: index + 1,
  }));
}

/** The orbit of a mount about where it rests, then the ellipses of its largest orders. */
export function orbit(study: MountStudy, mount: number, speed: number, seen: Seen): Series[] {
  const response = study.response.speeds[speed];
  const moved = study.points[mount]?.displacement[speed];
  if (!response || !moved) return [];
  const { right, up } = VIEWS[seen];
  const path = (chosen: readonly number[], angles: Float64Array) => {
    const along = (which: number) =>
      summed(
        chosen.map((index) => ({
          order: response.orders[index]?.order ?? 0,
          value: moved[index]?.[which] ?? [0, 0],
        })),
        angles,
      );
    return { x: along(right), y: along(up), along: angles, closed: true };
  };
  const sizes = moved.map((one) => amplitude([one[right], one[up]]));
  const most = Math.max(0, ...sizes);
  const largest = sizes
    .map((size, index) => ({ size, index }))
    .filter(({ size }) => size > FLAT * most)
    .sort((a, b) => b.size - a.size)
    .slice(0, DRAWN);
  const all = moved.map((_, index) => index);
  return [
    { name: "all orders", ...path(all, anglesOf(response)), colour: 1, width: 2.25 },
    ...largest.map(({ index }, place) => {
      const order = response.orders[index]?.order ?? 1;
      // An ellipse closes after one cycle of its order.
      const turn = Float64Array.from(
        { length: ANGLES },
        (_, step) => (2 * Math.PI * step) / (ANGLES * order),
      );
      return { name: orderTitle(order), ...path([index], turn), colour: place + 2, width: 1.5 };
    }),
  ];
}

/** How far any point of any orbit is from rest, along either axis of the view [m]: all are drawn to one scale. */
export function reach(orbits: readonly (readonly Series[])[]): number {
  let most = 0;
  for (const series of orbits.flat()) {
    for (const values of [series.x, series.y])
      for (let i = 0; i < values.length; i++) most = Math.max(most, Math.abs(values[i] as number));
  }
  return most;
}
