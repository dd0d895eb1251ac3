// Shear force and bending moment along a crankshaft, as series over its length.

import type { BeamLoads } from "../../../api/types";
import type { Series } from "../../plot/series";
import { size } from "../forces/curves";

/** Between planes the shear force is constant: every plane but the last starts a step. */
export function shear(beam: BeamLoads, index: number): Series[] {
  const stations = beam.stations;
  const steps = (of: (station: BeamLoads["stations"][number]) => number) => {
    const [x, y]: [number[], number[]] = [[], []];
    for (let i = 0; i + 1 < stations.length; i++) {
      const [from, to] = [stations[i], stations[i + 1]];
      if (!from || !to) continue;
      x.push(from.z, to.z);
      y.push(of(from), of(from));
    }
    return { x, y };
  };
  return [
    {
      name: "largest over the cycle",
      ...steps((station) => station.largest_shear.value),
      colour: 1,
      kind: "area",
    },
    { name: "at the crank angle", ...steps((station) => size(station.shear[index] ?? [0, 0])), colour: 2 },
  ];
}

/** Between planes the moment runs straight: its size bends the curve, so that it is drawn from its components. */
export function moment(beam: BeamLoads, index: number): Series[] {
  const x = beam.stations.map((station) => station.z);
  const now = finely(
    x,
    beam.stations.map((station) => station.moment[index] ?? [0, 0]),
  );
  return [
    {
      name: "largest over the cycle",
      x,
      y: beam.stations.map((station) => station.largest_moment.value),
      colour: 1,
      kind: "area",
    },
    { name: "at the crank angle", x: now.x, y: now.values.map(size), colour: 2 },
  ];
}

const PIECES = 8;

/** More points on the straight lines between complex values. */
export function finely(x: readonly number[], values: readonly (readonly [number, number])[]) {
  const out: { x: number[]; values: [number, number][] } = { x: [], values: [] };
  for (const [i, at] of x.entries()) {
    const [value, next, to] = [values[i], values[i + 1], x[i + 1]];
    if (!value) continue;
    if (!next || to === undefined) {
      out.x.push(at);
      out.values.push([value[0], value[1]]);
      continue;
    }
    for (let k = 0; k < PIECES; k++) {
      const share = k / PIECES;
      out.x.push(at + share * (to - at));
      out.values.push([value[0] + share * (next[0] - value[0]), value[1] + share * (next[1] - value[1])]);
    }
  }
  return out;
}
