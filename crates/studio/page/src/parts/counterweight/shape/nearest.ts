// A limit that stands in the way of every design, with the edit of the file that lets it give way.

import type { DesignLimit, Edit, NearestLimit, SweptRoom } from "../../../api/types";
import { parted, plain, type Written } from "../../balance/devices/devices";

/** Keys that hold a limit, where it is one of the file. */
const KEYS: Record<Exclude<DesignLimit, "balance">, string> = {
  mass: "counterweight_design.limits.mass",
  "swept-radius": "counterweight_design.limits.swept_radius",
  inertia: "counterweight_design.limits.inertia",
  thickness: "counterweight_design.thickness",
  "half-width": "counterweight_design.limits.half_width",
};

/** The value of the file with the limit at the nearest that can be met, rounded to the side on which it can be. */
export function eased(one: NearestLimit, written: Written, room: SweptRoom | null): Edit | undefined {
  if (one.limit === "balance") return easedBalance(one, written);
  // It is the clearance that leaves no more room: of what is in the way only the crankcase has a radius of its own.
  if (one.limit === "swept-radius" && room && room.radius <= one.asked) {
    if (room.limit.kind !== "crankcase") return undefined;
    return { path: "clearance.crankcase_radius", value: `${above(1e3 * (one.nearest + room.least))} mm` };
  }
  const path = KEYS[one.limit];
  const value = written(path);
  const most = Array.isArray(value) ? (value as unknown[]).at(-1) : value;
  const parts = parted(most);
  if (!parts || !(one.asked > 0)) return undefined;
  const wider = `${above((parts.number * one.nearest) / one.asked)} ${parts.unit}`;
  return { path, value: Array.isArray(value) && value.length === 2 ? [value[0] as unknown, wider] : wider };
}

function easedBalance(one: NearestLimit, written: Written): Edit {
  const path = "counterweight_design.balance";
  const value = written(path);
  const least = `${plain(Math.floor(one.nearest * 1e3) / 10)} %`;
  return { path, value: Array.isArray(value) && value.length === 2 ? [least, value[1] as unknown] : least };
}

/** The next number above with four digits that count. */
function above(value: number): string {
  const step = 10 ** (Math.floor(Math.log10(value)) - 3);
  return plain(Math.ceil(value / step - 1e-9) * step, 6);
}

/** As it stands in the file. */
export function easedWords(edit: Edit): string {
  return Array.isArray(edit.value) ? (edit.value as unknown[]).map(String).join(" to ") : String(edit.value);
}
