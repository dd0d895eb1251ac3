// How large loads are, so that rounding noise is told from loads: the rule of the program's reports.

import type { LoadSet, Loads } from "../../../api/types";
import { below, largestMoment } from "../../../state/rounding";

export interface Magnitude {
  force: number;
  couple: number;
  roll_moment: number;
  shaft_torque: number;
}

/** Below these values loads are noise [N, N m]. */
export function noise(loads: Loads): Magnitude {
  const sets = [
    loads.total,
    ...loads.parts.map((part) => part.loads),
    ...loads.cylinders.map((one) => one.loads),
  ];
  const most = (key: keyof Magnitude) => Math.max(0, ...sets.map((set) => reach(set, key)));
  const force = most("force");
  const moment = (key: keyof Magnitude) => below(largestMoment(most(key), force));
  return {
    force: below(force),
    couple: moment("couple"),
    roll_moment: moment("roll_moment"),
    shaft_torque: moment("shaft_torque"),
  };
}

/** Largest size of a quantity over the cycle. */
export function reach(set: LoadSet, key: keyof Magnitude): number {
  const { max, min } = set.peaks[key];
  return Math.max(Math.abs(max.value), Math.abs(min.value));
}
