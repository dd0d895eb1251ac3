// Lists and tables of criteria as they stand in the file: the stages and limits of `[balance]`.

import type { FileEntry, PlacedDiagnostic } from "../../../api/types";
import { split } from "./tables";
import type { Json } from "../text/written";

/** A criterion and, where several share a stage or where it is a limit, its value as typed. */
export interface Term {
  criterion: string;
  value: string | undefined;
}

/** Stages out of the value of a list: a text is one criterion, a table several at once. */
export function stagesOf(value: unknown): Term[][] {
  if (!Array.isArray(value)) return [];
  return value.map((stage: unknown) =>
    typeof stage === "object" && stage !== null
      ? Object.entries(stage).map(([criterion, share]) => ({ criterion, value: String(share) }))
      : [{ criterion: String(stage), value: undefined }],
  );
}

/** The list that says the same. */
export function written(stages: readonly Term[][]): Json {
  return stages
    .filter((stage) => stage.length > 0)
    .map((stage): Json => {
      const [only] = stage;
      if (stage.length === 1 && only && only.value === undefined) return only.criterion;
      return Object.fromEntries(stage.map((term) => [term.criterion, term.value ?? ""]));
    });
}

/** A limit with the path of its key. */
export interface Limit extends Term {
  path: string;
}

export function limitsOf(entries: readonly FileEntry[], path: string): Limit[] {
  return entries
    .filter((entry) => entry.path.startsWith(`${path}.`))
    .map((entry) => ({
      path: entry.path,
      criterion: split(entry.path).name.replaceAll('"', ""),
      value: String(entry.value),
    }));
}

/** Path of a criterion's key in a table. */
export function limitPath(table: string, criterion: string): string {
  return `${table}."${criterion.replaceAll('"', "")}"`;
}

/** What is said about a term, by the words that a message points at. */
export function saidAbout(term: Term, text: string, said: readonly PlacedDiagnostic[]): PlacedDiagnostic[] {
  return said.filter((one) => {
    const words = text.slice(one.span.start, one.span.end).trim().replace(/^"|"$/g, "");
    return words === term.criterion || (term.value !== undefined && words === term.value);
  });
}
