// What a plot is made of. All values are SI; the plot shows them in the units that are chosen.

import type { Measure } from "../../state/units.svelte";

/** Numbers over an axis, as results hold them. */
export type Values = ArrayLike<number>;

export interface Series {
  name: string;
  x: Values;
  y: Values;
  /** Number of its colour, from 1. */
  colour: number;
  /** Over the colours of a field: in ink, on a line of its own in the colour of the ground. */
  cased?: boolean;
  /**
   * Default: a line. `area` lies between `base` and `y`, `bars` stand on zero, an `arrow` goes from the first point to
   * the last.
   */
  kind?: "line" | "points" | "bars" | "area" | "arrow";
  /** Lower edge of an area; default: zero. */
  base?: Values;
  /** Default: as its place among the curves of its plot. */
  dash?: string;
  /** In px; default 1.75. */
  width?: number;
  /** Joins the last point with the first: what repeats. */
  closed?: boolean;
  /** What runs along a curve whose axes are two components, for the readout: the crank angle. */
  along?: Values;
  /** Names of single points, for the readout. */
  labels?: readonly string[];
  /** Left out of the plot until its name in the legend is pressed. */
  hidden?: boolean;
}

export interface Axis {
  name: string;
  measure: Measure;
  /** Unit in place of that of the measure, where the values are plain numbers: "of 1". */
  unit?: string;
  /** Default: what the series reach. */
  domain?: readonly [number, number];
  log?: boolean;
  /** Whether zero belongs to the axis. */
  zero?: boolean;
  /** Below this size stands rounding noise: it is shown as zero. */
  least?: number;
  /** Same distance below zero as above. */
  symmetric?: boolean;
  /** Grows to the left: y of an engine that turns the other way. */
  reversed?: boolean;
  /** Ticks at whole numbers only. */
  whole?: boolean;
}

/** A place that is marked. */
export interface Marker {
  x: number;
  y: number;
  name: string;
  colour?: number;
  /** Writes the name beside it. */
  shown?: boolean;
  /** The name alone, without a dot. */
  bare?: boolean;
}

/** A stretch of the x axis on a ground of its own. */
export interface Band {
  from: number;
  to: number;
  name: string;
  colour?: number;
}

/** A line across the plot at a value. */
export interface Rule {
  x?: number;
  y?: number;
  name: string;
}

/** A part of the ground in one colour. */
export interface Region {
  /** Of the legend of a saved picture. */
  name: string;
  colour: string;
  /** Lines across in place of the colour. */
  hatched?: boolean;
  outlines: readonly { x: Values; y: Values }[];
}

/** A quantity over both axes: colours under the curves. */
export interface Field {
  /** Each lies over those before. */
  regions: readonly Region[];
  /** What is read out at a place along x; `y`: where the pointer is, if it is on the ground. */
  read: (x: number, y: number | undefined) => string;
  /** All of it as a table. */
  table: () => string;
}

/** The crank angle in a plot over the crank angle: it can be dragged. */
export interface Cursor {
  value: number;
  set: (value: number) => void;
}

const COLOURS = 6;
/** From the second curve of a plot on: told apart on grey paper and by eyes that see fewer colours. */
const DASHES = ["8 3", "2.5 2.5", "10 3 2.5 3", "5 2", "10 3 2.5 3 2.5 3", "1.5 4"];

export function colour(number: number): string {
  return `var(--series-${((Math.max(1, number) - 1) % COLOURS) + 1})`;
}

export function paint(series: Series): string {
  return series.cased ? "var(--ink)" : colour(series.colour);
}

export function dash(series: Series): string {
  return series.dash ?? "";
}

const isLine = (series: Series) => (series.kind ?? "line") === "line";

/** Series of one plot with dashes of their own: the first curve is drawn through, what has dashes keeps them. */
export function dashed(series: readonly Series[]): readonly Series[] {
  const taken = new Set(series.map((one) => one.dash));
  const free = ["", ...DASHES.filter((one) => !taken.has(one))];
  let place = 0;
  return series.map((one) => {
    if (!isLine(one) || one.dash !== undefined) return one;
    const own =
      place < free.length ? (free[place] ?? "") : (free[1 + ((place - 1) % (free.length - 1))] ?? "");
    place += 1;
    return own === "" ? one : { ...one, dash: own };
  });
}
