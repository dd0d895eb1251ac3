// What is seen, as a file.

import { toSi } from "../../state/units.svelte";
import { table } from "./csv";
import { download, png, standalone } from "./picture";
import { dash, paint, type Axis, type Field, type Series } from "./series";
import { unitOf } from "./words";

export type Format = "svg" | "png" | "csv";

export interface Saved {
  title: string;
  /** Stem of the file's name. */
  file: string;
  /** Series in sight. */
  visible: readonly Series[];
  x: Axis;
  y: Axis;
  along: Axis | undefined;
  field: Field | undefined;
}

export async function save(format: Format, plot: Saved, svg: SVGSVGElement | undefined) {
  const stem = plot.file
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "");
  if (format === "csv") {
    const text =
      plot.field?.table() ??
      table(plot.visible, column(plot.x), column(plot.y), plot.along && column(plot.along));
    download(text, `${stem}.csv`, "text/csv");
    return;
  }
  if (!svg) return;
  const regions = plot.field?.regions.filter(({ hatched }) => !hatched) ?? [];
  const keys = [
    ...plot.visible.map((one) => ({
      name: one.name,
      colour: paint(one),
      dash: dash(one),
      filled: one.kind === "bars" || one.kind === "area" || one.kind === "points",
    })),
    ...regions.map(({ name, colour }) => ({ name, colour, dash: "", filled: true })),
  ];
  const drawing = standalone(svg, plot.title, keys.length > 1 ? keys : []);
  if (format === "svg") download(drawing, `${stem}.svg`, "image/svg+xml");
  else download(await png(drawing), `${stem}.png`);
}

function column(axis: Axis) {
  return { name: axis.name, unit: unitOf(axis), si: toSi(1, axis.measure) };
}
