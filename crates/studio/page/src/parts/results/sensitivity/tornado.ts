// Bars of an output over the ranges of the numbers of an engine, the longest first.

import type { OutputRange, SensitivityAnswer } from "../../../api/types";

export interface Bar {
  name: string;
  range: string;
  /** The output with the number at its lower and at its upper end [SI]; nothing where no engine is there. */
  ends: readonly [number | null, number | null];
  /** Largest change, over the nominal value where that is not rounding. */
  share: number | undefined;
}

export interface Tornado {
  bars: Bar[];
  /** What changes nothing. */
  idle: string[];
  /** From the smallest to the largest value of all bars, the nominal one among them. */
  domain: readonly [number, number];
}

/** Changes below this share of the largest one, or of the nominal value, are none. */
const NOTHING = 1e-6;

export function tornado({ inputs }: SensitivityAnswer, output: OutputRange): Tornado {
  const { nominal } = output;
  const all = output.ends.map((ends, index) => {
    const changes = ends.filter((end) => end !== null).map((end) => Math.abs(end - nominal));
    const input = inputs[index];
    return { name: input?.name ?? "", range: input?.range ?? "", ends, change: Math.max(0, ...changes) };
  });
  const largest = Math.max(0, ...all.map(({ change }) => change));
  const least = NOTHING * Math.max(largest, Math.abs(nominal));
  const strong = all.filter(({ change }) => change > least).sort((a, b) => b.change - a.change);
  const values = strong.flatMap(({ ends }) => ends.filter((end) => end !== null));
  return {
    bars: strong.map(({ name, range, ends, change }) => ({
      name,
      range,
      ends,
      share: Math.abs(nominal) > NOTHING * largest ? change / Math.abs(nominal) : undefined,
    })),
    idle: all.filter(({ change }) => change <= least).map(({ name }) => name),
    domain: [Math.min(nominal, ...values), Math.max(nominal, ...values)],
  };
}

/** Where a value stands between the ends of a domain, 0 to 1. */
export function place([from, to]: readonly [number, number], value: number): number {
  return to > from ? (value - from) / (to - from) : 0.5;
}
