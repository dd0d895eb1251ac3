// Which key of the file a dimension of the sketch belongs to: files say the same in several ways.

import type { FileEntry } from "../../../api/types";
import { shownTyped } from "../text/written";

export interface Named {
  path: string;
  /** As typed in the file. */
  text: string;
}

/** The first of these keys that the file has. */
export function first(entries: FileEntry[], paths: string[]): Named | undefined {
  for (const path of paths) {
    const entry = entries.find((one) => one.path === path);
    if (entry) return { path, text: shownTyped(entry.value) };
  }
  return undefined;
}

/** Keys of the cylinder at this place of the list, then those for all cylinders. */
export function ofCylinder(entries: FileEntry[], number: number, key: string, common: string[]): string[] {
  const own = entries.find((one) => /^cylinder\[\d+\]\.number$/.test(one.path) && one.value === number);
  const place = own ? own.path.replace(/\.number$/, "") : `cylinder[${number - 1}]`;
  return [`${place}.${key}`, ...common];
}
