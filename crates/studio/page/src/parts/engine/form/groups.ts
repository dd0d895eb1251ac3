// The groups of the form: every key of the file is in one of them.

import type { FileEntry, KeyInfo } from "../../../api/types";

export interface Group {
  name: string;
  /** Keys of the file itself, in this order. */
  keys: string[];
  /** Always shown and open: no engine goes without. */
  always: boolean;
}

const group = (name: string, keys: string[], always = false): Group => ({ name, keys, always });

const GROUPS = [
  group("Engine", ["name", "note", "strokes", "rotation", "origin", "version"], true),
  group("Layout", ["layout"], true),
  group("Speed and firing", ["speed", "firing"], true),
  group("Crank", ["crank"], true),
  group("Piston", ["piston"], true),
  group("Rod", ["rod", "articulated_rod"], true),
  group("Cylinders", ["cylinders", "cylinder"]),
  group("Crankshafts and throws", ["crankshaft", "throw"]),
  group("Counterweights", ["counterweights", "counterweight"]),
  group("Balance shafts", ["shaft"]),
  group("Gas and friction", ["gas", "friction"]),
  group("Flywheel", ["flywheel"]),
  group("Driveline and gears", ["driveline", "gear"]),
  group("Torsional vibration", ["torsion", "damper", "pendulum"]),
  group("Bearings", ["bearings"]),
  group("Stress of the crankshaft", ["stress"]),
  group("Block and mounts", ["block", "mount"]),
  group("Run in time", ["simulation", "load", "starter", "governor"]),
  group("Balance task", ["balance"]),
  group("Shapes of weights", ["counterweight_design", "shaft_weight_design"]),
  group("Clearance of the crankshaft", ["clearance"]),
  group("Tolerances", ["tolerances"]),
];

/** Keys without which there is no engine, unless the file says the same in another way: their fields are always there. */
const CORE: Record<string, string[]> = {
  "crank.stroke": ["crank.radius", "throw[0].radius"],
  "piston.mass": ["cylinder[0].piston.mass"],
  "rod.length": ["cylinder[0].rod.length"],
};

export function isCore(path: string, entries: FileEntry[]): boolean {
  const others = CORE[path];
  return others !== undefined && !entries.some((entry) => others.includes(entry.path));
}

/**
 * Keys that one type of a table needs and another may have: their fields are there with the table, so that none comes, goes or
 * moves when the type becomes another one.
 */
const STANDING: Record<string, string[]> = {
  damper: ["damping", "stiffness", "loss_factor"],
};

export function stands(table: string, key: string): boolean {
  return STANDING[table]?.includes(key) ?? false;
}

/** The groups, with a last one for keys that have no place in the others. */
export function grouped(keys: KeyInfo[]): Group[] {
  const placed = new Set(GROUPS.flatMap((one) => one.keys));
  const others = keys.map((key) => key.name).filter((name) => !placed.has(name));
  return others.length > 0 ? [...GROUPS, group("More", others)] : GROUPS;
}
