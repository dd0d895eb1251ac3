// How the samples of an output are distributed, from their percentiles.

import type { OutputScatter } from "../../../api/types";

/** Bins of a histogram. */
const BINS = 40;

export interface Histogram {
  /** Edges of the bins, rising: one more than there are bins. */
  edges: number[];
  /** Share of the samples in each. */
  shares: number[];
}

/** Share of the samples up to a value: straight between the percentiles. */
export function shareUpTo(own: OutputScatter, value: number): number {
  const known = own.percentiles.toSorted((a, b) => a.share - b.share);
  const [first, last] = [known[0], known.at(-1)];
  if (!first || !last || value < first.value) return 0;
  if (value >= last.value) return 1;
  const next = known.findIndex((one) => one.value > value);
  const [from, to] = [known[next - 1], known[next]];
  if (!from || !to) return 1;
  return from.share + ((to.share - from.share) * (value - from.value)) / (to.value - from.value);
}

/** Bins of equal width from the smallest to the largest sample; none where all samples are equal. */
export function histogram(own: OutputScatter, bins = BINS): Histogram {
  const width = (own.most - own.least) / bins;
  if (!(width > 0)) return { edges: [], shares: [] };
  const edges = Array.from({ length: bins + 1 }, (_, place) => own.least + place * width);
  const upTo = edges.map((edge) => shareUpTo(own, edge));
  upTo[bins] = 1;
  return { edges, shares: upTo.slice(1).map((share, place) => share - (upTo[place] ?? 0)) };
}

export function percentile(own: OutputScatter, share: number): number {
  return own.percentiles.find((one) => one.share === share)?.value ?? NaN;
}

/** The outline of the bins, from left to right. */
export function outline({ edges, shares }: Histogram): { x: number[]; y: number[] } {
  const [x, y]: [number[], number[]] = [[], []];
  shares.forEach((share, place) => {
    x.push(edges[place] ?? NaN, edges[place + 1] ?? NaN);
    y.push(share, share);
  });
  return { x, y };
}

/** Nominal values below this share of what the tolerances can do are rounding. */
const ROUNDING = 1e-9;

export function nominal(own: OutputScatter, bound: number): number {
  return Math.abs(own.nominal) > ROUNDING * bound ? own.nominal : 0;
}
