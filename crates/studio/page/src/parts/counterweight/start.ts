// Sections to start from where a file does not say yet what its crankshaft looks like: sizes in proportion to bore and stroke.

import type { DeviceSummary, Edit, FileEntry } from "../../api/types";
import { baseOf, parted, plain, type Written } from "../balance/devices/devices";
import type { Sizes } from "./shape/sizes";

const DENSITY = "7850 kg/m3";

/** Whole or half millimetres, as a size of the file. */
function mm(length: number, part = 0.5): string {
  return `${plain(Math.round((length * 1e3) / part) * part, 6)} mm`;
}

/**
 * Weights in the planes of throws, shared out among the webs beside the pin that stand free: halves on both load the engine alike.
 * `undefined` where one of the weights stands elsewhere, or has an amount that cannot be shared out.
 */
export function ontoWebs(
  weights: readonly DeviceSummary[],
  written: Written,
  free: readonly number[],
): Edit[] | undefined {
  const edits: Edit[] = [];
  const more: Edit[] = [];
  for (const weight of weights) {
    const number = weight.path === null ? undefined : written(`${weight.path}.throw`);
    const base = baseOf(weight, written);
    const parts = parted(base?.typed);
    if (weight.path === null || typeof number !== "number" || !base || !parts) return undefined;
    const [first = 2 * number - 1, ...others] = beside(number, free);
    const share = `${plain(parts.number / (1 + others.length), 12)} ${parts.unit}`;
    edits.push(
      { path: `${weight.path}.web`, value: first },
      { path: `${weight.path}.throw`, value: null },
      { path: `${weight.path}.${base.key}`, value: share },
      // It was named after the throw.
      { path: `${weight.path}.name`, value: null },
    );
    for (const web of others) {
      const entry: Record<string, unknown> = { web, [base.key]: share };
      for (const key of ["radius", "angle", "crankshaft"]) {
        const value = written(`${weight.path}.${key}`);
        if (value !== undefined) entry[key] = value;
      }
      more.push({ path: `counterweight[${weights.length + more.length}]`, value: entry });
    }
  }
  return edits.length > 0 ? [...edits, ...more] : undefined;
}

/** The webs of a throw that carry weights: those that stand free, or both where none does. */
function beside(number: number, free: readonly number[]): number[] {
  const both = [2 * number - 1, 2 * number];
  const own = both.filter((web) => free.includes(web));
  return own.length > 0 ? own : both;
}

/** Weights of the short form on webs, each on those that stand free alone: a web between two pins has no room for one. */
export function onFreeWebs(weights: readonly DeviceSummary[], free: readonly number[]): DeviceSummary[] {
  return weights.flatMap((weight) => {
    const web = Number(/^web (\d+)$/.exec(weight.name)?.[1] ?? NaN);
    if (weight.path !== null || !Number.isFinite(web)) return [weight];
    const own = beside(Math.ceil(web / 2), free);
    return own.includes(web) ? [{ ...weight, unbalance: (2 * weight.unbalance) / own.length }] : [];
  });
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
  // The big end of a master rod holds the knuckle pins.
  const bigEnd = Math.max(0.44 * of.bore, of.knuckle > 0 ? of.knuckle + 0.16 * of.bore : 0);
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
  return [
    ...gone.map((path): Edit => ({ path, value: null })),
    ...webEdits(of, entries),
    { path: "crank.body", value: bodyStart(of) },
  ];
}

/** The distance of the webs where the file has none, or one that leaves no room for two webs between neighbouring pins. */
export function webEdits(of: Sizes, entries: readonly FileEntry[]): Edit[] {
  const own = entries.some((entry) => /^throw\[\d+\]\.web_distance$/.test(entry.path));
  const value = `${plain(of.webDistance * 1e3, 9)} mm`;
  const same = entries.some((entry) => entry.path === "crank.web_distance" && entry.value === value);
  return own || same ? [] : [{ path: "crank.web_distance", value }];
}
