// Loads as series of plots.

import type { LoadSet, Loads, OrderLoads, PartLoads, Trace } from "../../../api/types";
import type { Series } from "../../plot/series";
import type { By } from "../look.svelte";

export type Component = Exclude<keyof Trace, "theta">;

export const PARTS: Record<PartLoads["part"], string> = {
  rotating: "rotating",
  reciprocating: "reciprocating",
  "rod-inertia": "rod inertia",
  counterweights: "counterweights",
  shafts: "balance shafts",
};

export const WHOLE = "whole engine";

/** The whole, then what it is split into, once its curves are there: name, colour, loads. */
export function sets(loads: Loads, by: By): { name: string; colour: number; set: LoadSet }[] {
  return split(loads, by).filter(({ set }) => set.trace.theta.length > 0);
}

function split(loads: Loads, by: By): { name: string; colour: number; set: LoadSet }[] {
  const whole = { name: WHOLE, colour: 1, set: loads.total };
  if (by === "parts") {
    const numbers = Object.keys(PARTS);
    return [
      whole,
      ...loads.parts.map(({ part, loads: set }) => ({
        name: PARTS[part],
        colour: 2 + numbers.indexOf(part),
        set,
      })),
    ];
  }
  if (by === "cylinders") {
    return [
      whole,
      ...loads.cylinders.map(({ cylinder, loads: set }) => ({
        name: `cylinder ${cylinder}`,
        colour: 1 + cylinder,
        set,
      })),
    ];
  }
  return [whole];
}

/** A component over the crank angle. */
export function over(loads: Loads, by: By, component: Component, name?: string, colour?: number): Series[] {
  return sets(loads, by).map(({ name: own, colour: number, set }, index) => ({
    name: name ?? own,
    x: set.trace.theta,
    y: set.trace[component],
    colour: colour ?? number,
    width: index === 0 ? 2.25 : 1.5,
  }));
}

/** The path of the tip of the force or couple arrow: `y` to the right, `x` up, as seen from the free end. */
export function path(loads: Loads, by: By, of: "force" | "couple"): Series[] {
  return sets(loads, by).map(({ name, colour, set }, index) => ({
    name,
    x: set.trace[`${of}_y`],
    y: set.trace[`${of}_x`],
    along: set.trace.theta,
    closed: true,
    colour,
    width: index === 0 ? 2.25 : 1.5,
  }));
}

export function size([re, im]: readonly [number, number]): number {
  return Math.hypot(re, im);
}

/** Where a complex amplitude points [rad]. */
export function angle([re, im]: readonly [number, number]): number {
  return Math.atan2(im, re);
}

/** Amplitudes by order, what turns against the crank to the left. */
export function twoSided(orders: readonly OrderLoads[], of: "force" | "couple"): Series[] {
  const turning = orders.filter((one) => one.order > 0);
  const still = orders.filter((one) => one.order === 0);
  const series: Series[] = [
    {
      name: "against the crank",
      x: turning.map((one) => -one.order).reverse(),
      y: turning.map((one) => size(one[`${of}_backward`])).reverse(),
      colour: 2,
      kind: "bars",
    },
    {
      name: "with the crank",
      x: turning.map((one) => one.order),
      y: turning.map((one) => size(one[`${of}_forward`])),
      colour: 1,
      kind: "bars",
    },
  ];
  const mean = still.map((one) => size(one[`${of}_forward`]));
  if (mean.some((value) => value > 0))
    series.splice(1, 0, { name: "mean", x: [0], y: mean, colour: 3, kind: "bars" });
  return series;
}
