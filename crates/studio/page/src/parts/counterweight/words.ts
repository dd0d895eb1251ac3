// Obstacles, objectives and dimensions in words.

import type { Obstacle } from "../../api/types";
import type { Measure } from "../../state/units.svelte";
import type { Key } from "./shape/outline";

export function obstacleName(obstacle: Obstacle): string {
  switch (obstacle.kind) {
    case "crankcase":
      return "crankcase";
    case "big-end-side":
      return `side of big end ${obstacle.cylinder}`;
    default:
      return `${obstacle.kind} ${obstacle.cylinder}`;
  }
}

export type Objective = "mass" | "swept radius" | "inertia" | "thickness";
export const OBJECTIVES: readonly Objective[] = ["mass", "swept radius", "inertia", "thickness"];

const MEASURES: Record<Objective, Measure> = {
  mass: "mass",
  "swept radius": "length",
  inertia: "inertia",
  thickness: "length",
};

/** `swept-radius` and `swept radius` alike. */
export function objective(name: string): Objective {
  const plain = name.replaceAll("-", " ");
  return OBJECTIVES.find((one) => one === plain) ?? "mass";
}

export function objectiveMeasure(name: Objective): Measure {
  return MEASURES[name];
}

export interface DimensionName {
  key: Key;
  name: string;
  symbol: string;
}

export const DIMENSIONS: readonly DimensionName[] = [
  { key: "web_radius", name: "Web radius", symbol: "r" },
  { key: "rectangle_height", name: "Rectangle height", symbol: "h" },
  { key: "shoulder_height", name: "Shoulder height", symbol: "H" },
  { key: "arc_radius", name: "Arc radius", symbol: "R" },
  { key: "arc_angle", name: "Arc angle", symbol: "α" },
  { key: "thickness", name: "Thickness", symbol: "t" },
];

/** How a distance stands against the one that is wanted. */
export function verdict(
  distance: number,
  least: number | null,
  kept: boolean,
): { mark: "good" | "warn" | "bad"; words: string } {
  if (distance <= 0) return { mark: "bad", words: "touches" };
  if (!kept) return { mark: "bad", words: "too close" };
  // A tenth above what is wanted, and whatever lies on it.
  if (least !== null && distance < 1.1 * least) return { mark: "warn", words: "just kept" };
  return { mark: "good", words: "kept" };
}
