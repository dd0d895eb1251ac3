// How long the bars of published methods are, and which method is furthest from its optimum.

import type { MethodKind, MethodResult } from "../../../api/types";

export type Load = "force" | "couple";

/** The largest value of a load that any method leaves. */
export function largest(methods: readonly MethodResult[], load: Load): number {
  return Math.max(0, ...methods.map(({ left }) => left?.[load].method ?? 0));
}

/** Length of a bar [%]. */
export function width(value: number, most: number): number {
  return most > 0 ? (100 * value) / most : 0;
}

/** The command that tells all of a method, without the file. */
export function commandOf(kind: MethodKind): string {
  switch (kind.of) {
    case "matrix":
      return "balance --method matrix";
    case "half":
      return "balance --method half";
    case "share":
      return "balance --method half --balance-factor '50 %'";
    case "sweep":
      return "balance --method sweep";
    case "arrangement":
      return `compare --arrangements ${kind.number}`;
    case "arrangements":
      return "compare --arrangements 1,2,3,4,5,6,7,8,9";
  }
}

/** Methods of one source, in their order. */
export function bySource(methods: readonly MethodResult[]): { source: string; methods: MethodResult[] }[] {
  const groups: { source: string; methods: MethodResult[] }[] = [];
  for (const method of methods) {
    const last = groups.at(-1);
    if (last?.source === method.source) last.methods.push(method);
    else groups.push({ source: method.source, methods: [method] });
  }
  return groups;
}

/** The method whose force could be made smallest in proportion with its own devices, in a sentence. */
export function gap(methods: readonly MethodResult[]): string {
  const ratios = methods.flatMap(({ name, left }) => {
    const force = left?.force;
    if (!force || force.optimum === null || force.method <= 0) return [];
    return [{ name, share: 1 - force.optimum / force.method }];
  });
  const widest = ratios.toSorted((a, b) => b.share - a.share)[0];
  if (!widest || widest.share < 0.005) return "";
  return `Most is left to gain with “${widest.name}”: the optimum of its devices has ${Math.round(100 * widest.share)} % less force.`;
}
