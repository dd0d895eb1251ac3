// What an arrangement costs, in the ways that it can be counted.

import type { Price } from "../../../api/types";
import type { Measure } from "../../../state/units.svelte";

export interface Cost {
  key: string;
  name: string;
  measure: Measure;
  of: (price: Price) => number;
}

export const COSTS: readonly [Cost, ...Cost[]] = [
  { key: "mass", name: "Added mass", measure: "mass", of: (price) => price.weight_mass + price.drive_mass },
  { key: "inertia", name: "Added inertia at the crank", measure: "inertia", of: (price) => price.inertia },
  {
    key: "bearing",
    name: "Largest bearing load of a shaft",
    measure: "force",
    of: (price) => price.bearing_load,
  },
  { key: "power", name: "Drive power", measure: "power", of: (price) => price.drive_power },
  { key: "unbalance", name: "Added unbalance", measure: "unbalance", of: (price) => price.unbalance },
  { key: "shafts", name: "Balance shafts", measure: "none", of: (price) => price.shafts },
];
