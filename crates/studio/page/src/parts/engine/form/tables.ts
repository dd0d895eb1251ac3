// What the server tells about the keys of the file, looked up by the path of a key.

import type { FileEntry, KeyInfo, KeyTable, PlacedDiagnostic, Reading } from "../../../api/types";

export type Shape = "value" | "table" | "list" | "stages" | "limits";

export class Tables {
  #byPath: Map<string, KeyTable>;

  constructor(tables: KeyTable[]) {
    this.#byPath = new Map(tables.map((table) => [table.path, table]));
  }

  /** The table of `path`, an entry of a list included: `counterweight[2].shape`. */
  find(path: string): KeyTable | undefined {
    return this.#byPath.get(path.replace(/\[\d+\]/g, "[]"));
  }

  key(path: string): KeyInfo | undefined {
    const { parent, name } = split(path);
    return this.find(parent)?.keys.find((key) => key.name === name);
  }

  /** What stands at `path`: a value, a table, a list of tables, or a list or a table of criteria. */
  shape(path: string): Shape {
    if (this.find(path)) return "table";
    if (this.find(`${path}[0]`)) return "list";
    const { kind = "", wanted = "" } = this.key(path) ?? {};
    // Tables whose keys are the user's own.
    if (kind === "table") return wanted.includes("criteria") ? "limits" : "table";
    return /^a list of (criteria|orders of loads)$/.test(wanted) ? "stages" : "value";
  }
}

/** `crank.body.density` → `crank.body` and `density`. */
export function split(path: string): { parent: string; name: string } {
  const name = /(?:"[^"]*"|[^."]+)$/.exec(path)?.[0] ?? path;
  return { parent: path.slice(0, -name.length).replace(/\.$/, ""), name };
}

export function join(parent: string, name: string): string {
  return parent === "" ? name : `${parent}.${name}`;
}

/** Whether `path` is `root` or lies within it. */
export function within(path: string, root: string): boolean {
  return path === root || path.startsWith(`${root}.`) || path.startsWith(`${root}[`);
}

export function present(entries: FileEntry[], path: string): boolean {
  return entries.some((entry) => within(entry.path, path));
}

/** How many entries a list of tables has. */
export function count(entries: FileEntry[], list: string): number {
  let most = 0;
  for (const { path } of entries) {
    if (!path.startsWith(`${list}[`)) continue;
    most = Math.max(most, Number.parseInt(path.slice(list.length + 1), 10) + 1);
  }
  return most;
}

/** Names of the keys that stand directly in the table of `path`, in the order of the file. */
export function children(entries: FileEntry[], path: string): string[] {
  const start = path === "" ? "" : `${path}.`;
  const names = entries
    .filter((entry) => entry.path.startsWith(start))
    .map((entry) => /^(?:"[^"]*"|[^.["]+)/.exec(entry.path.slice(start.length))?.[0] ?? "");
  return [...new Set(names)].filter(Boolean);
}

/** Whether a key means something for this layout. */
export function fits(key: KeyInfo, layout: string): boolean {
  return key.layouts.length === 0 || key.layouts.includes(layout);
}

/** `big_end_mass` → `Big end mass`; single letters are axes and stay small. */
export function label(name: string): string {
  const words = name.replaceAll("_", " ").replaceAll('"', "");
  return words.length === 1 ? words : words.charAt(0).toUpperCase() + words.slice(1);
}

/** The key that a message misses in its table. */
export function missed(message: string): string | undefined {
  return /^`(\w+)` is missing in \[/.exec(message)?.[1];
}

/**
 * The key that a message is about. The server names the value at its place; a message about something that is missing
 * stands at the header of its table.
 */
export function subject(reading: Reading, about: PlacedDiagnostic): string | null {
  const { text, entries } = reading;
  const start = text.lastIndexOf("\n", about.span.start - 1) + 1;
  const entry = entries.find((one) => one.path === about.path);
  const own = entry && about.span.start >= text.lastIndexOf("\n", entry.span.start - 1) + 1;
  if (own && about.span.start <= entry.span.end) return entry.path;
  const header = /^[ \t]*(\[\[?)([^[\]\n]+)\]/.exec(text.slice(start));
  if (!header?.[2]) return null;
  const name = header[2].trim();
  if (header[1] === "[") return name;
  const before = text
    .slice(0, start)
    .split("\n")
    .filter((line) => line.trim().startsWith(`[[${name}]]`));
  return `${name}[${before.length}]`;
}
