// In which measure a number of a study is shown, by its SI unit.

import type { Measure } from "../../state/units.svelte";

const MEASURES: Record<string, Measure> = {
  N: "force",
  "N m": "moment",
  rad: "angle",
  m: "length",
  "kg m": "unbalance",
};

export function measureOf(unit: string): Measure {
  return MEASURES[unit] ?? "none";
}
