// From values to pixels: limits, ticks and the map itself.

import { scaleLinear, scaleLog } from "d3-scale";
import type { Axis, Series, Values } from "./series";

/** Values of an axis, in the unit that is shown. */
export type Range = readonly [number, number];

/** `pixel = scale * value + shift`, of the logarithm on a logarithmic axis; values are SI. */
export interface PixelMap {
  scale: number;
  shift: number;
  log: boolean;
}

export function place(map: PixelMap, value: number): number {
  return map.scale * (map.log ? Math.log10(value) : value) + map.shift;
}

/** The value [SI] at a pixel. */
export function valueAt(map: PixelMap, pixel: number): number {
  const value = (pixel - map.shift) / map.scale;
  return map.log ? 10 ** value : value;
}

/** Limits [SI] on pixels `from` to `to`. */
export function pixelMap(limits: Range, from: number, to: number, log = false): PixelMap {
  const [low, high] = log ? [Math.log10(limits[0]), Math.log10(limits[1])] : limits;
  const scale = (to - from) / (high - low || 1);
  return { scale, shift: from - scale * low, log };
}

/** Smallest and largest of what is finite (and positive, for a logarithm). */
export function extent(values: Values, range: [number, number], log = false): [number, number] {
  let [low, high] = range;
  for (let i = 0; i < values.length; i++) {
    const value = values[i] as number;
    if (!Number.isFinite(value) || (log && value <= 0)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return [low, high];
}

/**
 * What the axis shows as long as nobody zooms [SI]. `unit`: SI value of one unit of the axis; `nice`: from tick to tick.
 */
export function limits(
  axis: Axis,
  series: readonly Series[],
  of: "x" | "y",
  unit: number,
  ticks: number,
  nice: boolean,
): Range {
  if (axis.domain) return axis.domain;
  let range: [number, number] = [Infinity, -Infinity];
  for (const one of series) {
    range = extent(one[of], range, axis.log);
    if (of === "y" && one.base) range = extent(one.base, range, axis.log);
    else if (of === "y" && (one.kind === "bars" || one.kind === "area")) range = extent([0], range, axis.log);
  }
  if (axis.zero && !axis.log) range = extent([0], range);
  if (range[0] > range[1]) range = axis.log ? [unit, 10 * unit] : [0, unit];
  const least = axis.least ?? 0;
  if (axis.log) {
    const [low, high] = range[0] === range[1] ? [range[0] / 2, range[1] * 2] : range;
    return niced(
      scaleLog()
        .domain([low / unit, high / unit])
        .nice()
        .domain(),
      unit,
    );
  }
  if (axis.symmetric) {
    const reach = Math.max(Math.abs(range[0]), Math.abs(range[1]));
    range = [-reach, reach];
  }
  if (least > 0 && Math.max(Math.abs(range[0]), Math.abs(range[1])) <= least) {
    // What stands there is noise: bars and sizes stay on zero, all else is centred.
    range = axis.zero && range[0] >= 0 ? [0, unit] : [-unit, unit];
  }
  if (range[0] === range[1]) {
    const half = Math.abs(range[0]) / 2 || unit;
    range = [range[0] - half, range[1] + half];
  }
  if (!nice) return range;
  return niced(
    scaleLinear()
      .domain([range[0] / unit, range[1] / unit])
      .nice(ticks)
      .domain(),
    unit,
  );
}

function niced(domain: number[], unit: number): Range {
  return [(domain[0] as number) * unit, (domain[1] as number) * unit];
}

/** Both limits widened about their middles so that a unit has the same length along x and y. */
export function equalised(x: Range, y: Range, width: number, height: number): [Range, Range] {
  const unit = Math.max((x[1] - x[0]) / width, (y[1] - y[0]) / height);
  const about = (range: Range, length: number): Range => {
    const middle = (range[0] + range[1]) / 2;
    return [middle - (unit * length) / 2, middle + (unit * length) / 2];
  };
  return [about(x, width), about(y, height)];
}

export interface Tick {
  /** SI. */
  value: number;
  label: string;
}

/** Steps of angles that engineers count in [degrees]. */
const ANGLES = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 45, 60, 90, 180, 360, 720, 1440];

/** About `count` ticks of limits [SI]. */
export function axisTicks(range: Range, axis: Axis, unit: number, count: number): Tick[] {
  const [low, high] = [range[0] / unit, range[1] / unit];
  let values: number[];
  if (axis.log) {
    const all = scaleLog().domain([low, high]).ticks(count);
    // Whole powers alone where all would crowd.
    const leading = (value: number) => Math.abs(value / 10 ** Math.round(Math.log10(value)) - 1) < 1e-9;
    values = all.length > 2 * count ? all.filter(leading) : all;
    const crowded = values.length > count;
    return values.map((value) => ({
      value: value * unit,
      label: crowded && !leading(value) ? "" : label(value, value),
    }));
  }
  let step: number;
  if (axis.measure === "angle") {
    const wanted = (high - low) / count;
    step = ANGLES.find((known) => known >= wanted * 0.8) ?? 3600;
    values = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high * (1 + 1e-12) + 1e-9; k++)
      values.push(k * step);
    if (values.length < 2) {
      values = scaleLinear().domain([low, high]).ticks(count);
      step = (values[1] ?? 1) - (values[0] ?? 0);
    }
  } else {
    // Whole numbers are short.
    values = scaleLinear()
      .domain([low, high])
      .ticks(axis.whole ? 2 * count : count);
    if (axis.whole) values = values.filter((value) => Math.abs(value - Math.round(value)) < 1e-9);
    const [first, second] = values;
    step = first === undefined || second === undefined ? 1 : second - first;
  }
  return values.map((value) => ({ value: value * unit, label: label(value, step) }));
}

/** A value with as many decimals as its step needs. */
export function label(value: number, step: number): string {
  const size = Math.floor(Math.log10(Math.abs(step)) + 1e-9);
  if (Math.abs(value) < Math.abs(step) * 1e-9) return "0";
  if (size < -5 || Math.abs(value) >= 1e7) {
    const digits = Math.max(0, Math.floor(Math.log10(Math.abs(value)) + 1e-9) - size);
    return value.toExponential(Math.min(digits, 6)).replace("e+", "e").replace("-", "−");
  }
  const text = Math.abs(value).toFixed(Math.max(0, -size));
  const [whole, part] = text.split(".");
  // A thin space between thousands, from ten thousand on.
  const grouped =
    (whole as string).length > 4 ? (whole as string).replace(/\B(?=(\d{3})+$)/g, "\u202f") : whole;
  return `${value < 0 ? "−" : ""}${grouped}${part ? `.${part}` : ""}`;
}
