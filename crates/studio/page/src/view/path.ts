// The key of the engine file that a part of the scene stands for, as far as the file has it.

import type { DeviceSummary, FileEntry, ScenePart } from "../api/types";

/**
 * The key to edit: the own one of the cylinder where the file has one (`[[cylinder]]` with its `number`, or in order),
 * else that of all cylinders; of a counterweight its own entry, or the shares that it comes from.
 */
export function keyOf(part: ScenePart, entries: FileEntry[], weights: DeviceSummary[]): string | null {
  const has = (path: string) =>
    entries.some((entry) => entry.path === path || entry.path.startsWith(`${path}.`));
  if (part.weight !== null) {
    const own = weights[part.weight]?.path;
    if (!own) return entries.find((entry) => entry.path.startsWith("counterweights."))?.path ?? null;
    return has(`${own}.shape`) ? `${own}.shape` : `${own}.unbalance`;
  }
  const { path, cylinder } = part;
  if (path === null || cylinder === null) return path;
  const numbered = entries.find(
    (entry) => /^cylinder\[\d+\]\.number$/.test(entry.path) && entry.value === cylinder,
  );
  const isListed = entries.some((entry) => /^cylinder\[\d+\]\.number$/.test(entry.path));
  const own = numbered ? numbered.path.replace(".number", "") : isListed ? null : `cylinder[${cylinder - 1}]`;
  return own !== null && has(`${own}.${path}`) ? `${own}.${path}` : path;
}
