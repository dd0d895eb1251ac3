// Throws and cylinders of the engine for the sketch, out of the general form of its file as the server writes it.

import type { FileEntry } from "../../../api/types";

export interface Throw {
  crankshaft: number;
  /** Direction from the crankshaft's zero, clockwise [rad]. */
  angle: number;
  z: number;
  radius: number;
  /** Between the middle planes of its webs [m]; 0 where the file does not say. */
  web: number;
}

export interface Cylinder {
  number: number;
  /** Place of its throw in the list, from 0. */
  throw: number;
  /** Direction of its axis from +x towards +y [rad]. */
  angle: number;
  z: number;
  offset: number;
  /** 0 where the file does not say. */
  bore: number;
  /** From the crankpin to the piston pin with the rod stretched, that of an articulated rod's knuckle included. */
  rod: number;
  /** From the crankpin to the knuckle pin of an articulated rod; 0 for others. */
  knuckle: number;
}

export interface Axis {
  name: string;
  x: number;
  y: number;
  ratio: number;
}

export interface Shape {
  crankshafts: Axis[];
  throws: Throw[];
  cylinders: Cylinder[];
  shafts: Axis[];
  weights: { z: number; angle: number; crankshaft: number; unbalance: number }[];
}

// The general form is written by the program itself, in these units.
const UNITS: Record<string, number> = {
  m: 1,
  mm: 1e-3,
  um: 1e-6,
  rad: 1,
  deg: Math.PI / 180,
  "kg m": 1,
  "kg mm": 1e-3,
  "g mm": 1e-6,
};

/** SI value of a quantity of the general form; `undefined` for anything else. */
export function si(value: unknown): number | undefined {
  if (typeof value === "number") return value;
  const found = typeof value === "string" ? /^(\S+) (.+)$/.exec(value) : null;
  const unit = UNITS[found?.[2] ?? ""];
  const number = Number(found?.[1]);
  return unit === undefined || !Number.isFinite(number) ? undefined : number * unit;
}

export function shape(entries: FileEntry[]): Shape | undefined {
  const values = new Map(entries.map((entry) => [entry.path, entry.value]));
  const number = (path: string, fallback = 0) => si(values.get(path)) ?? fallback;
  const list = <T>(name: string, make: (path: string, at: number) => T): T[] => {
    const out: T[] = [];
    const has = (start: string) => entries.some((entry) => entry.path.startsWith(start));
    while (has(`${name}[${out.length}].`)) out.push(make(`${name}[${out.length}]`, out.length));
    return out;
  };
  const axis = (path: string, at: number): Axis => ({
    name: String(values.get(`${path}.name`) ?? at + 1),
    x: number(`${path}.x`),
    y: number(`${path}.y`),
    ratio: ratio(values.get(`${path}.ratio`)),
  });
  const throws = list("throw", (path) => ({
    crankshaft: number(`${path}.crankshaft`, 1) - 1,
    angle: number(`${path}.angle`),
    z: number(`${path}.z`),
    radius: number(`${path}.radius`),
    web: number(`${path}.web_distance`),
  }));
  const cylinders = list("cylinder", (path, at) => ({
    number: number(`${path}.number`, at + 1),
    throw: number(`${path}.throw`, 1) - 1,
    angle: number(`${path}.angle`),
    z: number(`${path}.z`, throws[number(`${path}.throw`, 1) - 1]?.z),
    offset: number(`${path}.offset`),
    bore: number(`${path}.bore`),
    rod: number(`${path}.rod.length`) + number(`${path}.rod.knuckle_radius`),
    knuckle: number(`${path}.rod.knuckle_radius`),
  }));
  if (throws.length === 0 || cylinders.length === 0 || throws.some((one) => one.radius <= 0))
    return undefined;
  return {
    crankshafts: list("crankshaft", axis),
    throws,
    cylinders,
    shafts: list("shaft", axis),
    weights: list("counterweight", (path) => ({
      z: number(`${path}.z`),
      angle: number(`${path}.angle`),
      crankshaft: number(`${path}.crankshaft`, 1) - 1,
      unbalance: number(`${path}.unbalance`),
    })),
  };
}

function ratio(value: unknown): number {
  if (typeof value === "number") return value;
  const [over, under = 1] = String(value ?? 1)
    .split("/")
    .map(Number);
  return (over ?? 1) / under;
}

/** Cylinders of one crankshaft that look the same way. */
export interface Bank {
  crankshaft: number;
  angle: number;
  cylinders: Cylinder[];
}

export function banks(given: Shape): Bank[] {
  const found: Bank[] = [];
  for (const cylinder of given.cylinders) {
    const crankshaft = given.throws[cylinder.throw]?.crankshaft ?? 0;
    const same = found.find(
      (bank) => bank.crankshaft === crankshaft && Math.abs(turn(bank.angle - cylinder.angle)) < 1e-6,
    );
    if (same) same.cylinders.push(cylinder);
    else found.push({ crankshaft, angle: cylinder.angle, cylinders: [cylinder] });
  }
  return found;
}

/** An angle between minus and plus half a turn. */
export function turn(angle: number): number {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}

/** Throws of one crankshaft that point the same way, with their numbers from 1. */
export function directions(given: Shape, crankshaft: number): { angle: number; numbers: number[] }[] {
  const found: { angle: number; numbers: number[] }[] = [];
  given.throws.forEach((one, at) => {
    if (one.crankshaft !== crankshaft) return;
    const same = found.find((direction) => Math.abs(turn(direction.angle - one.angle)) < 1e-3);
    if (same) same.numbers.push(at + 1);
    else found.push({ angle: one.angle, numbers: [at + 1] });
  });
  return found;
}

/** Numbers in lines of at most three. */
export function lines(numbers: number[]): string[] {
  const out: string[] = [];
  for (let at = 0; at < numbers.length; at += 3) out.push(numbers.slice(at, at + 3).join(" "));
  return out;
}

/** What the view along the crank needs in x and y, in units of `radius`: crank circles, cylinders, shafts. */
export function extent(given: Shape, radius: number) {
  const at = (axis: Axis | undefined) => [(axis?.x ?? 0) / radius, (axis?.y ?? 0) / radius] as const;
  const discs = [
    ...given.crankshafts.map((axis) => [...at(axis), 1.3] as const),
    ...given.shafts.map((axis) => [...at(axis), 0.5] as const),
    ...banks(given).map((bank) => {
      const [x, y] = at(given.crankshafts[bank.crankshaft]);
      return [x + 2.5 * Math.cos(bank.angle), y + 2.5 * Math.sin(bank.angle), 0.75] as const;
    }),
  ];
  const span = (place: 0 | 1) =>
    [
      Math.min(...discs.map((disc) => disc[place] - disc[2])),
      Math.max(...discs.map((disc) => disc[place] + disc[2])),
    ] as const;
  return { x: span(0), y: span(1) };
}
