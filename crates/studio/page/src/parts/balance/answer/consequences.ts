// Rows of what other weights do to an engine, in words.

import type { Consequence, Consequences, Effect } from "../../../api/types";
import type { Measure } from "../../../state/units.svelte";
import { criterionName, measureOf } from "../words";

type Quantity = Consequence["quantity"];

const QUANTITIES: Record<Quantity, { name: string; measure: Measure }> = {
  force: { name: "Force, peak", measure: "force" },
  couple: { name: "Couple, peak", measure: "moment" },
  "roll-moment": { name: "Roll moment, peak", measure: "moment" },
  "mount-force": { name: "Mount force, largest", measure: "force" },
  "main-load-rms": { name: "Main-bearing load, rms", measure: "force" },
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

/** Less than this share of the larger one is no change. */
const CHANGE = 1e-6;

/** The consequence that says the same as a criterion, if there is one. */
function same({ criterion, before }: Effect, found: Consequences): Consequence | undefined {
  const numbered = (quantity: Quantity, place: number) =>
    found.rows.filter((row) => row.quantity === quantity)[place];
  if (typeof criterion === "string") return undefined;
  if ("main-rms" in criterion) {
    const mains = criterion["main-rms"];
    return typeof mains === "object" ? numbered("main-load-rms", mains.one) : undefined;
  }
  if (!("peak" in criterion)) return undefined;
  const load = criterion.peak;
  if (typeof load === "object") {
    return "main-load" in load ? numbered("main-load-peak", load["main-load"]) : undefined;
  }
  if (load === "force" || load === "couple" || load === "roll-moment") return numbered(load, 0);
  if (load === "largest-mount-force") {
    // On springs it counts at the speeds that are given, where the other counts them all.
    const mounts = numbered("mount-force", 0);
    return mounts && Math.abs(mounts.before - before) <= CHANGE * mounts.before ? mounts : undefined;
  }
  return load === "bending-moment" && found.bending.length === 1 ? numbered(load, 0) : undefined;
}

function changeOf({ before, after }: Effect): Consequence["change"] {
  if (Math.abs(after - before) <= CHANGE * Math.max(Math.abs(before), Math.abs(after))) return "unchanged";
  return after > before ? "worse" : "better";
}

/** What an answer does, every quantity once: the criteria that were asked for, then what else changes. */
export function allRows(effects: readonly Effect[], found: Consequences): Row[] {
  const told = new Set<Consequence>();
  const asked = effects.map((effect) => {
    const twin = same(effect, found);
    if (twin) told.add(twin);
    const name = criterionName(effect.criterion);
    return {
      name: name.charAt(0).toUpperCase() + name.slice(1),
      part: "",
      measure: measureOf(effect.criterion),
      before: effect.before,
      after: effect.after,
      change: twin?.change ?? changeOf(effect),
      first: true,
    };
  });
  return [...asked, ...rows({ ...found, rows: found.rows.filter((row) => !told.has(row)) })];
}

/** "main 3", "mains 2–3"; nothing for the whole engine. */
export function partName(part: Consequence["part"], several: boolean): string {
  if (part.kind === "engine") return "";
  const own = several ? `crankshaft ${part.crankshaft}` : "";
  if (part.kind === "crankshaft") return own;
  const name = part.kind === "main" ? `main ${part.main}` : `mains ${part.bay}–${part.bay + 1}`;
  return own === "" ? name : `${own}, ${name}`;
}
