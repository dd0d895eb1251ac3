// A plot as a table: every point of the series shown, with all digits, in the units shown.

import type { Series, Values } from "./series";

export interface Column {
  name: string;
  unit: string;
  /** SI value of one unit. */
  si: number;
}

/** A word, quoted where needed; an apostrophe stands before one that a spreadsheet would take for a formula. */
export function cell(text: string): string {
  const formula = /^[=+\-@\t\r]/.test(text) && !Number.isFinite(Number(text));
  const word = formula ? `'${text}` : text;
  return /[",\r\n]/.test(word) ? `"${word.replaceAll('"', '""')}"` : word;
}

export function head(column: Column, of = ""): string {
  const name = of === "" ? column.name : of;
  return cell(column.unit ? `${name} [${column.unit}]` : name);
}

/** One table of series over common places, or pairs of columns where each has its own. */
export function table(series: readonly Series[], x: Column, y: Column, along?: Column): string {
  const columns: { head: string; values: Values; si: number; text?: readonly string[] }[] = [];
  const first = series[0];
  const common = first !== undefined && series.every((one) => same(one.x, first.x));
  const plane = series.some((one) => one.along);
  if (common && !plane && first) {
    if (first.labels && series.length === 1)
      columns.push({ head: "Name", values: first.x, si: 1, text: first.labels });
    columns.push({ head: head(x), values: first.x, si: x.si });
  }
  for (const one of series) {
    if (one.along && along)
      columns.push({ head: head(along, `${one.name}: ${along.name}`), values: one.along, si: along.si });
    if (!common || plane) {
      if (one.labels)
        columns.push({ head: cell(`${one.name}: name`), values: one.x, si: 1, text: one.labels });
      columns.push({ head: head(x, `${one.name}: ${x.name}`), values: one.x, si: x.si });
    }
    if (one.base) columns.push({ head: head(y, `${one.name}: from`), values: one.base, si: y.si });
    columns.push({
      head: head(y, !common || plane ? `${one.name}: ${y.name}` : one.name),
      values: one.y,
      si: y.si,
    });
  }
  const rows = Math.max(0, ...columns.map((column) => column.values.length));
  const lines = [columns.map((column) => column.head).join(",")];
  for (let row = 0; row < rows; row++) {
    lines.push(
      columns
        .map(({ values, si, text }) => {
          if (row >= values.length) return "";
          return text ? cell(text[row] ?? "") : number((values[row] as number) / si);
        })
        .join(","),
    );
  }
  return lines.join("\r\n") + "\r\n";
}

function number(value: number): string {
  return Number.isFinite(value) ? String(value) : "";
}

function same(one: Values, other: Values): boolean {
  if (one === other) return true;
  if (one.length !== other.length) return false;
  for (let i = 0; i < one.length; i++) if (one[i] !== other[i]) return false;
  return true;
}
