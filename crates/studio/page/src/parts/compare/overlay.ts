// Loads of several states as series of one plot.

import type { Loads, OrderLoads } from "../../api/types";
import type { Series } from "../plot/series";
import { size, type Component } from "../results/forces/curves";

export interface Drawn {
  name: string;
  colour: number;
  loads: Loads;
}

export function curves(states: readonly Drawn[], component: Component): Series[] {
  return states.map(({ name, colour, loads }, index) => ({
    name,
    colour,
    x: loads.total.trace.theta,
    y: loads.total.trace[component],
    width: index === 0 ? 2.25 : 1.5,
  }));
}

export function paths(states: readonly Drawn[], of: "force" | "couple"): Series[] {
  return states.map(({ name, colour, loads }, index) => ({
    name,
    colour,
    x: loads.total.trace[`${of}_y`],
    y: loads.total.trace[`${of}_x`],
    along: loads.total.trace.theta,
    closed: true,
    width: index === 0 ? 2.25 : 1.5,
  }));
}

/** Amplitudes of all states side by side; what turns against the crank stands at negative orders. */
export function spectra(states: readonly Drawn[], of: "force" | "couple"): Series[] {
  return states.map(({ name, colour, loads }) => {
    const turning = loads.total.orders.filter((one) => one.order > 0);
    const backward = turning.map((one) => [-one.order, size(one[`${of}_backward`])] as const).reverse();
    const still = loads.total.orders
      .filter((one) => one.order === 0)
      .map((one) => [0, size(one[`${of}_forward`])] as const);
    const forward = turning.map((one) => [one.order, size(one[`${of}_forward`])] as const);
    const bars = [...backward, ...still, ...forward];
    return { name, colour, kind: "bars", x: bars.map(([order]) => order), y: bars.map(([, value]) => value) };
  });
}

export function rolls(states: readonly Drawn[]): Series[] {
  return states.map(({ name, colour, loads }) => {
    const turning: OrderLoads[] = loads.total.orders.filter((one) => one.order > 0);
    return {
      name,
      colour,
      kind: "bars",
      x: turning.map((one) => one.order),
      y: turning.map((one) => size(one.roll_moment)),
    };
  });
}
