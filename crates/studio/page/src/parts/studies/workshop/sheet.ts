// A workshop sheet from the fields of a form: the text that `lanchester workshop` reads.

import type { Shape } from "../../engine/sketch/geometry";

/** A field of the sheet: key, name, whether it must be given. */
export const PARTS = [
  ["big_end", "Big end of the rod", true],
  ["bearing", "Bearing shells", false],
  ["small_end", "Small end of the rod", true],
  ["piston", "Piston", true],
  ["piston_pin", "Piston pin", false],
  ["rings", "Rings", false],
  ["locks", "Locks of the pin", false],
] as const;
export type Part = (typeof PARTS)[number][0];

export interface Fields {
  name: string;
  pins: number;
  rods: number;
  oil: string;
  /** Empty: the one that leaves least. */
  share: string;
  parts: Record<Part, string>;
  /** Highest service speed and balance quality grade; empty: no grade. */
  grade: string;
  speed: string;
  mass: string;
  /** z of its centre of mass: the grade is shared out among the bearings by it. */
  centre: string;
  /** Ends of the crank where a balancing machine shows the unbalance. */
  displays: { z: string; unbalance: string; angle: string }[];
  /** Planes in which the crank is corrected. */
  planes: { name: string; z: string; radius: string }[];
}

/** Crankpins of an engine, and the most rods that one of them carries. */
export function pinsOf({
  throws,
  cylinders,
}: Pick<Shape, "throws" | "cylinders">): Pick<Fields, "pins" | "rods"> {
  const rods = throws.map((_, at) => cylinders.filter((cylinder) => cylinder.throw === at).length);
  return { pins: throws.length, rods: Math.max(1, ...rods) };
}

const text = (value: string) => JSON.stringify(value);

/** A plain number has the unit that stands beside its field. */
export function withUnit(value: string, unit: string): string {
  const bare = value.trim().replace(",", ".");
  return bare !== "" && Number.isFinite(Number(bare)) ? `${bare} ${unit}` : value.trim();
}

function line(key: string, value: string, unit: string): string[] {
  return value.trim() === "" ? [] : [`${key} = ${text(withUnit(value, unit))}`];
}

/** The sheet, without what was left empty. */
export function sheetOf(fields: Fields): string {
  const parts = PARTS.flatMap(([key]) => line(key, fields.parts[key], "g"));
  const rotor = [...line("mass", fields.mass, "kg"), ...line("centre", fields.centre, "mm")];
  rotor.push(...line("speed", fields.speed, "rpm"));
  const measured = fields.displays.filter(({ unbalance }) => unbalance.trim() !== "");
  if (measured.length > 0) {
    const supports = fields.displays.map(({ z }) => text(withUnit(z, "mm")));
    if (supports.length === 2) rotor.push(`supports = [${supports.join(", ")}]`);
  }
  if (fields.grade.trim() !== "") rotor.push(`grade = ${text(fields.grade.trim())}`);
  const blocks = [
    [`name = ${text(fields.name)}`],
    parts.length > 0
      ? [
          "[bobweight]",
          `pins = ${fields.pins}`,
          `rods = ${fields.rods}`,
          ...line("oil", fields.oil, "g"),
          ...line("reciprocating_share", fields.share, "%"),
        ]
      : [],
    parts.length > 0 ? ["[parts]", ...parts] : [],
    rotor.length > 0 ? ["[rotor]", ...rotor] : [],
    ...(measured.length > 0
      ? fields.planes.map(({ name, z, radius }) => [
          "[[plane]]",
          `name = ${text(name)}`,
          ...line("z", z, "mm"),
          ...line("radius", radius, "mm"),
        ])
      : []),
    ...measured.map(({ z, unbalance, angle }) => [
      "[[display]]",
      ...line("z", z, "mm"),
      ...line("unbalance", unbalance, "g mm"),
      ...line("angle", angle, "deg"),
    ]),
  ];
  return blocks
    .filter((block) => block.length > 0)
    .map((block) => block.join("\n") + "\n")
    .join("\n");
}
