// Where the energy of a run goes, as bands whose widths are in proportion.

import type { SimulationAnswer } from "../../api/types";
import { ledger } from "./simulated";

/** A work or a change of what is stored, as a band between the trunk and its name. */
export interface Band {
  name: string;
  /** [J]. */
  energy: number;
  /** Upper edge at the name and at the trunk, and width [px]. */
  outer: number;
  inner: number;
  wide: number;
}

/** Height of the trunk and of the gap between two bands [px]. */
export const TRUNK = 150;
const GAP = 16;

/** Bands below this share of the whole are left out. */
const THIN = 1e-3;

/** Bands on the left (where it comes from) and on the right (where it goes), about the middle of the picture; `null` where nothing flows. */
export function bands(
  parts: SimulationAnswer["energy"],
): { left: Band[]; right: Band[]; height: number } | null {
  const { from, to } = ledger(parts);
  const sum = (side: typeof from) => side.reduce((all, part) => all + part.energy, 0);
  const whole = Math.max(sum(from), sum(to));
  if (!(whole > 0 && Number.isFinite(whole))) return null;
  const shown = (side: typeof from) => side.filter((part) => part.energy > THIN * whole);
  const height = TRUNK + GAP * Math.max(shown(from).length, shown(to).length, 1) + 16;
  const place = (side: typeof from): Band[] => {
    const tall = (TRUNK * sum(side)) / whole;
    let outer = (height - tall - GAP * Math.max(0, side.length - 1)) / 2;
    let inner = (height - tall) / 2;
    return side.map(({ name, energy }) => {
      const wide = (TRUNK * energy) / whole;
      const band = { name, energy, outer, inner, wide };
      outer += wide + GAP;
      inner += wide;
      return band;
    });
  };
  return { left: place(shown(from)), right: place(shown(to)), height };
}

/** The outline of a band from `x0`, at its name, to `x1`, at the trunk. */
export function outline({ outer, inner, wide }: Band, x0: number, x1: number): string {
  const half = (x0 + x1) / 2;
  const there = `M${x0},${outer} C${half},${outer} ${half},${inner} ${x1},${inner}`;
  return `${there} V${inner + wide} C${half},${inner + wide} ${half},${outer + wide} ${x0},${outer + wide} Z`;
}
