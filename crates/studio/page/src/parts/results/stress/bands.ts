// A stress with its error band, in words.

import type { Extrapolated } from "../../../api/types";
import { digits } from "../../../state/units.svelte";

/** "412 ± 3.1 (0.75 %)": what three meshes tend to, and half the width of its band; `shown` takes it to the unit of the table. */
export function banded(found: Extrapolated | null, shown: (stress: number) => number): string {
  if (!found) return "none";
  const share = found.value === 0 ? 0 : Math.abs(found.band / found.value);
  return `${digits(shown(found.value), 4)} ± ${digits(shown(found.band), 2)} (${digits(100 * share, 2)} %)`;
}

/** Whether the meshes say something of the fillets at all: they differ across them. */
export function differ(meshes: readonly { fillet_elements: number }[]): boolean {
  return new Set(meshes.map((mesh) => mesh.fillet_elements)).size > 1;
}
