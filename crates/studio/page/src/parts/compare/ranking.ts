// The ranking of a comparison in words.

import type { Comparison } from "../../api/types";
import { below } from "../../state/rounding";
import type { Measure } from "../../state/units.svelte";

interface Criterion {
  /** "Least force". */
  name: string;
  measure: Measure;
}

export const CRITERIA: Record<string, Criterion> = {
  force: { name: "Force", measure: "force" },
  couple: { name: "Couple", measure: "moment" },
  "roll-moment": { name: "Roll moment", measure: "moment" },
  "mount-force": { name: "Force at the mounts", measure: "force" },
  "firing-unevenness": { name: "Unevenness of firing", measure: "share" },
  "torque-unevenness": { name: "Unevenness of torque", measure: "share" },
  flywheel: { name: "Flywheel", measure: "inertia" },
  "added-unbalance": { name: "Added unbalance", measure: "unbalance" },
  shafts: { name: "Balance shafts", measure: "none" },
};

/** "A (20 N), then B (1361 N, 68 times as much)", best first; those that cannot be told apart stand together. */
export function sentence(
  ranking: Comparison["rankings"][number],
  names: readonly string[],
  written: (value: number, measure: Measure) => string,
): string {
  const measure = CRITERIA[ranking.criterion]?.measure ?? "none";
  const noise = below(...ranking.places.map((place) => place.value));
  const groups = new Map<number, { names: string[]; value: number }>();
  for (const { engine, rank, value } of ranking.places) {
    const group = groups.get(rank) ?? { names: [], value };
    group.names.push(names[engine] ?? `engine ${engine + 1}`);
    groups.set(rank, group);
  }
  const told = [...groups].sort((a, b) => a[0] - b[0]).map(([, group]) => group);
  const first = told[0];
  if (!first) return "";
  const zero = (value: number) => Math.abs(value) <= noise;
  if (told.length === 1) {
    return zero(first.value) ? "None has any." : `All the same: ${written(first.value, measure)}.`;
  }
  const words = told.map(({ names: group, value }, index) => {
    const times = index > 0 && !zero(first.value) ? `, ${factor(value / first.value)}` : "";
    return `${together(group)} (${zero(value) ? "none" : written(value, measure)}${times})`;
  });
  return `${words.join(", then ")}.`;
}

function together(names: readonly string[]): string {
  if (names.length < 2) return names.join("");
  return `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`;
}

/** "12 % more", "3.4 times as much". */
export function factor(ratio: number): string {
  if (ratio < 2) {
    const percent = 100 * (ratio - 1);
    return `${percent.toFixed(percent < 10 ? 1 : 0)} % more`;
  }
  return `${Number(ratio.toPrecision(ratio < 10 ? 2 : 3))} times as much`;
}
