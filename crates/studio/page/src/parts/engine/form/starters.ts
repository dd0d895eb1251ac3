// What a new entry of a list begins with, where there is none to be copied.

import type { FileEntry, KeyTable } from "../../../api/types";
import { count } from "./tables";
import { type Json, written } from "../text/written";

const STARTERS: Record<string, Record<string, Json>> = {
  "counterweight[]": { throw: 1, unbalance: "0 kg m" },
  "shaft[]": { ratio: -1, weights: [{ z: "0 mm", unbalance: "0 kg m" }] },
  "shaft[].weights[]": { z: "0 mm", unbalance: "0 kg m" },
  "throw[]": { angle: "0 deg", z: "0 mm" },
  "cylinder[]": { number: 1 },
  "mount[]": { name: "mount", x: "0 mm", y: "0 mm", z: "0 mm", stiffness: "200 N/mm" },
};

/** A copy of the list's last entry, else a start of its own, else the examples of the keys that it needs. */
export function starter(entries: FileEntry[], list: string, table: KeyTable): Json {
  const last = count(entries, list) - 1;
  if (last >= 0) {
    const copy = tree(entries, `${list}[${last}]`);
    // Copies differ from what they were made of: names and numbers go on.
    if (typeof copy.number === "number") copy.number += 1;
    else delete copy.name;
    return copy;
  }
  return (
    STARTERS[table.path] ??
    Object.fromEntries(
      table.keys
        .filter((key) => key.required)
        .map((key) => [key.name, written(key, key.example.replaceAll('"', ""))]),
    )
  );
}

/** Everything below `root` as one value. */
export function tree(entries: FileEntry[], root: string): Record<string, Json> {
  const out: Record<string, Json> = {};
  for (const entry of entries) {
    if (!entry.path.startsWith(`${root}.`)) continue;
    // "weights[1].z" in steps: "weights", 1, "z".
    const steps = [...entry.path.slice(root.length).matchAll(/\.([^.[]+)|\[(\d+)\]/g)].map((found) =>
      found[2] === undefined ? (found[1] ?? "") : Number(found[2]),
    );
    let at: Node = out;
    steps.forEach((step, depth) => {
      if (depth === steps.length - 1) at[step] = entry.value as Json;
      else at = (at[step] ??= typeof steps[depth + 1] === "number" ? [] : {}) as Node;
    });
  }
  return out;
}

/** A table or a list, filled alike. */
type Node = Record<string | number, Json>;
