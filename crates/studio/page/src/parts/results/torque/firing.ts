// When which cylinder does what, as series: a bar of strokes a cylinder.

import type { FiringChart } from "../../../api/types";
import type { Series } from "../../plot/series";

type Kind = FiringChart["cylinders"][number]["strokes"][number]["stroke"];

/** Wide enough to be read as a bar [px]. */
const THICK = 13;

export function strokes(chart: FiringChart): Series[] {
  const kinds: Kind[] = [];
  for (const { strokes } of chart.cylinders)
    for (const { stroke } of strokes) if (!kinds.includes(stroke)) kinds.push(stroke);
  return kinds.map((kind, index) => {
    const one = { x: [] as number[], y: [] as number[], labels: [] as string[] };
    const add = (cylinder: number, from: number, to: number) => {
      // Both ends, then a gap.
      one.x.push(from, to, NaN);
      one.y.push(cylinder, cylinder, NaN);
      const name = `cylinder ${cylinder}, ${kind}`;
      one.labels.push(`${name} begins`, `${name} ends`, "");
    };
    for (const { cylinder, strokes } of chart.cylinders) {
      for (const { stroke, from, to } of strokes) {
        if (stroke !== kind) continue;
        add(cylinder, from, Math.min(to, chart.period));
        // What ends beyond the period began before it.
        if (to > chart.period * (1 + 1e-9)) add(cylinder, 0, to - chart.period);
      }
    }
    return { name: kind, ...one, colour: index + 1, width: THICK, dash: "" };
  });
}
