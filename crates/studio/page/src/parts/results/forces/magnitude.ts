// How large loads are, so that rounding noise is told from loads: the rule of the program's reports.

import type { LoadSet, Loads } from "../../../api/types";

export interface Magnitude {
  force: number;
  couple: number;
  roll_moment: number;
  shaft_torque: number;
}

/** A load below this share of what cancels is rounding noise. */
const NOISE = 1e-9;
/** Couples of an engine that is all in one plane vanish with all their parts: this lever [m] tells noise then. */
const LEVER = 0.01;

/** Below these values loads are noise [N, N m]. */
export function noise(loads: Loads): Magnitude {
  const sets = [
    loads.total,
    ...loads.parts.map((part) => part.loads),
    ...loads.cylinders.map((one) => one.loads),
  ];
  const most = (key: keyof Magnitude) => Math.max(0, ...sets.map((set) => reach(set, key)));
  const force = most("force");
  const least = LEVER * force;
  return {
    force: NOISE * force,
    couple: NOISE * Math.max(most("couple"), least),
    roll_moment: NOISE * Math.max(most("roll_moment"), least),
    shaft_torque: NOISE * Math.max(most("shaft_torque"), least),
  };
}

/** Largest size of a quantity over the cycle. */
export function reach(set: LoadSet, key: keyof Magnitude): number {
  const { max, min } = set.peaks[key];
  return Math.max(Math.abs(max.value), Math.abs(min.value));
}
