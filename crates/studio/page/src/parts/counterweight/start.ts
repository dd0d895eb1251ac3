// Sections to start from where a file does not say yet what its crankshaft looks like: sizes in proportion to bore and stroke.

import type { DeviceSummary, Edit, FileEntry } from "../../api/types";
import { baseOf, parted, plain, type Written } from "../balance/devices";

/** What the engine tells of itself [m]. */
export interface Sizes {
  bore: number;
  stroke: number;
  /** From the crank axis to the piston pin at bottom dead centre. */
  bottom: number;
  /** Between the middles of a throw's two webs. */
  webDistance: number;
  /** The smallest distance of the middles of any two neighbouring webs. */
  narrowest: number;
  /** Rods on a crankpin. */
  rods: number;
}

const DENSITY = "7850 kg/m3";

/** Whole or half millimetres, as a size of the file. */
function mm(length: number, part = 0.5): string {
  return `${plain(Math.round((length * 1e3) / part) * part, 6)} mm`;
}

/** Distances of webs from the weights that stand on them; `undefined` as long as none does. */
export function websOf(
  weights: readonly DeviceSummary[],
): { distance: number; narrowest: number } | undefined {
  const places = weights
    .map((weight) => ({ web: Number(/^web (\d+)$/.exec(weight.name)?.[1] ?? NaN), z: weight.z }))
    .filter((place) => Number.isFinite(place.web))
    .sort((a, b) => a.web - b.web);
  let distance = Infinity;
  let narrowest = Infinity;
  places.forEach((place, index) => {
    const next = places[index + 1];
    if (next?.web !== place.web + 1) return;
    const apart = next.z - place.z;
    if (apart <= 0) return;
    narrowest = Math.min(narrowest, apart);
    if (place.web % 2 === 1) distance = Math.min(distance, apart);
  });
  return Number.isFinite(distance) ? { distance, narrowest } : undefined;
}

/**
 * Weights in the planes of throws as two halves on the webs beside the pin, which load the engine alike; `undefined` where one of them
 * stands elsewhere, or has an amount that cannot be halved.
 */
export function halvedOntoWebs(weights: readonly DeviceSummary[], written: Written): Edit[] | undefined {
  const edits: Edit[] = [];
  const more: Edit[] = [];
  for (const weight of weights) {
    const number = weight.path === null ? undefined : written(`${weight.path}.throw`);
    const base = baseOf(weight, written);
    const parts = parted(base?.typed);
    if (weight.path === null || typeof number !== "number" || !base || !parts) return undefined;
    const half = `${plain(parts.number / 2, 12)} ${parts.unit}`;
    const entry: Record<string, unknown> = { web: 2 * number, [base.key]: half };
    for (const key of ["radius", "angle", "crankshaft"]) {
      const value = written(`${weight.path}.${key}`);
      if (value !== undefined) entry[key] = value;
    }
    edits.push(
      { path: `${weight.path}.web`, value: 2 * number - 1 },
      { path: `${weight.path}.throw`, value: null },
      { path: `${weight.path}.${base.key}`, value: half },
      // It was named after the throw.
      { path: `${weight.path}.name`, value: null },
    );
    more.push({ path: `counterweight[${weights.length + more.length}]`, value: entry });
  }
  return edits.length > 0 ? [...edits, ...more] : undefined;
}

/** Thickness of a web: the rest between the middles of two of them stays for pin and journal. */
function thickness(of: Sizes): number {
  return Math.min(0.55 * of.narrowest, 0.3 * of.bore);
}

export function bodyStart(of: Sizes) {
  const pin = 0.56 * of.bore;
  return {
    density: DENSITY,
    journal_diameter: mm(0.64 * of.bore),
    pin_diameter: mm(pin),
    web_thickness: mm(thickness(of)),
    web_radius: mm(0.52 * of.bore),
    pin_end_radius: mm(0.74 * pin),
    end_journals: [mm(0.35 * of.bore), mm(0.45 * of.bore)],
  };
}

export function shapesStart(of: Sizes) {
  return {
    minimise: "mass",
    web_radius: mm(0.52 * of.bore),
    rectangle_height: ["0 mm", mm(0.5 * of.bore)],
    shoulder_height: ["0 mm", mm(0.5 * of.bore)],
    arc_radius: [mm(0.62 * of.bore), mm(1.1 * of.bottom)],
    arc_angle: ["60 deg", "200 deg"],
    thickness: mm(thickness(of)),
  };
}

export function clearanceStart(of: Sizes) {
  const bigEnd = 0.44 * of.bore;
  const width = (of.webDistance - thickness(of)) / of.rods - 1.5e-3;
  return {
    least: "1.5 mm",
    crankcase_radius: mm(Math.max(of.stroke / 2 + bigEnd, 0.95 * of.bottom) + 0.008, 1),
    skirt_length: mm(0.1 * of.bore),
    liner_end: mm(of.bottom - 0.05 * of.bore),
    liner_wall: "4 mm",
    big_end_radius: mm(bigEnd),
    big_end_width: mm(Math.max(4e-3, width)),
    shank_width: mm(0.3 * of.bore),
    shank_thickness: mm(Math.max(3e-3, Math.min(0.2 * of.bore, 0.75 * width))),
  };
}

/** `[crank.body]` stands in place of what the file says of the masses of a throw. */
export function bodyEdits(of: Sizes, entries: readonly FileEntry[]): Edit[] {
  const old = ["unbalance", "pin_mass", "web_mass", "web_radius"].map((key) => `crank.${key}`);
  const gone = old.filter((path) => entries.some((entry) => entry.path === path));
  return [...gone.map((path): Edit => ({ path, value: null })), { path: "crank.body", value: bodyStart(of) }];
}
