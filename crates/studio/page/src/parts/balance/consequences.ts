// Rows of what other weights do to an engine, in words.

import type { Consequence, Consequences } from "../../api/types";
import type { Measure } from "../../state/units.svelte";

type Quantity = Consequence["quantity"];

const QUANTITIES: Record<Quantity, { name: string; measure: Measure }> = {
  force: { name: "Force, peak", measure: "force" },
  couple: { name: "Couple, peak", measure: "moment" },
  "roll-moment": { name: "Roll moment, peak", measure: "moment" },
  "mount-force": { name: "Mount force, largest", measure: "force" },
  "main-load-rms": { name: "Main-bearing load, RMS", measure: "force" },
  "main-load-peak": { name: "Main-bearing load, peak", measure: "force" },
  "bending-moment": { name: "Bending moment, largest", measure: "moment" },
  "counterweight-mass": { name: "Counterweights, mass", measure: "mass" },
  "counterweight-unbalance": { name: "Counterweights, unbalance", measure: "unbalance" },
  "shaft-unbalance": { name: "Balance shafts, unbalance", measure: "unbalance" },
  "balance-rate": { name: "Balance rate", measure: "share" },
};

export interface Row {
  name: string;
  part: string;
  measure: Measure;
  before: number;
  after: number;
  change: Consequence["change"];
  /** Whether it is the first of its quantity. */
  first: boolean;
}

/** The rows that have something to say, of these quantities or of all. */
export function rows(found: Consequences, of?: readonly Quantity[]): Row[] {
  const several = found.bending.length > 1;
  const shown = found.rows.filter(
    (row) => (row.before !== 0 || row.after !== 0) && (of === undefined || of.includes(row.quantity)),
  );
  return shown.map((row, index) => ({
    ...QUANTITIES[row.quantity],
    part: partName(row.part, several),
    before: row.before,
    after: row.after,
    change: row.change,
    first: shown[index - 1]?.quantity !== row.quantity,
  }));
}

/** "main 3", "mains 2–3"; nothing for the whole engine. */
export function partName(part: Consequence["part"], several: boolean): string {
  if (part.kind === "engine") return "";
  const own = several ? `crankshaft ${part.crankshaft}` : "";
  if (part.kind === "crankshaft") return own;
  const name = part.kind === "main" ? `main ${part.main}` : `mains ${part.bay}–${part.bay + 1}`;
  return own === "" ? name : `${own}, ${name}`;
}
