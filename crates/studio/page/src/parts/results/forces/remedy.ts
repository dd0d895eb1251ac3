// What a finding of the diagnosis asks of the optimiser, so that its remedy stands in the file.

import type { EngineSummary, Finding } from "../../../api/types";
import { reach } from "../../balance/devices/devices";

export interface Remedy {
  /** What the button says. */
  label: string;
  /** What is asked of `/api/balance`, but for the text. */
  settings: {
    free: "none" | "throws" | "devices";
    locked: string[];
    shafts: string[];
    minimise: string[];
  };
}

/** `undefined` where nothing can be inserted: roll moments and orders that no simple device removes. */
export function remedyOf(
  { quantity, order, sense, remedy }: Finding,
  engine: EngineSummary,
): Remedy | undefined {
  if (quantity === "roll-moment") return undefined;
  const other = quantity === "force" ? "couple" : "force";
  const planes = quantity === "couple" ? ", two planes" : "";
  if (remedy === "balance-shaft") {
    const against = sense === "backward";
    const times = order === 1 ? "" : ` at ${order} × crank speed`;
    const far = millimetres(reach(engine));
    // Beside the crank, on the side where no shaft of the engine is.
    const side = engine.shafts.some((shaft) => shaft.y > 0 && shaft.y < 0.15) ? -100 : 100;
    const at = quantity === "couple" ? `${-far} mm, ${far} mm` : "0 mm";
    return {
      label: `Add shaft${times}, ${against ? "against" : "with"} the crank${planes}`,
      settings: {
        free: "none",
        locked: [],
        shafts: [`${against ? -order : order} @ 0 mm, ${side} mm @ ${at}`],
        minimise: [`${quantity} order ${order}`],
      },
    };
  }
  if (remedy !== "crank-weights") return undefined;
  const has = engine.counterweights.length > 0;
  return {
    label: has ? `Set counterweights${planes}` : `Add counterweights${planes}`,
    settings: {
      free: has ? "devices" : "throws",
      locked: has ? engine.shafts.map(({ name }) => name) : [],
      shafts: [],
      minimise: [quantity, other].map((load) => `${load} order ${order}`),
    },
  };
}

function millimetres(length: number): number {
  return Number((1e3 * length).toPrecision(4));
}
