// A number of the engine file on a slider: how far it goes, and how it is written back.

import type { KeyInfo } from "../../../api/types";
import type { Json } from "../text/written";

/** A value of the file taken apart: 86 and " mm". */
export interface Amount {
  number: number;
  /** What stands behind the number, the space before it included; empty for a bare number. */
  unit: string;
  /** Whether the file has it as a text. */
  text: boolean;
}

export interface Span {
  least: number;
  most: number;
  step: number;
}

const AMOUNT = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(\s*\S.*)?$/i;
/** A fraction is no single number. */
const FRACTION = /^\s*\//;
const DEGREES = /^\s*(deg|°)$/i;
const RADIANS = /^\s*rad$/i;
const PERCENT = /^\s*%$/;
/** Keys of places and offsets: both sides of zero are meant. */
const PLACED = /^(x|y|z|.*offset|place|point|centre|center|centre_of_mass|position|path)$/;
/** Values that are no amounts to slide: words and whole numbers. */
const WHOLE = new Set(["text", "flag", "truth", "whole", "choice", "table", "tables"]);

export function amount(value: unknown): Amount | null {
  if (typeof value === "number")
    return Number.isFinite(value) ? { number: value, unit: "", text: false } : null;
  const found = typeof value === "string" ? AMOUNT.exec(value) : null;
  if (!found || FRACTION.test(found[2] ?? "")) return null;
  return { number: Number(found[1]), unit: (found[2] ?? "").trimEnd(), text: true };
}

/** The numbers of a value, one or several; none where it is no amount. */
export function amounts(info: KeyInfo | undefined, value: unknown): Amount[] {
  if (!info || WHOLE.has(info.kind) || info.choices.length > 0) return [];
  const items: unknown[] = Array.isArray(value) ? value : [value];
  const all = items.map(amount);
  if (items.length === 0 || items.length > MOST || all.includes(null)) return [];
  const found = all as Amount[];
  // Lists of bare numbers count things: cylinders, throws, orders.
  if (Array.isArray(value) && found.every((one) => one.unit === "")) return [];
  return found;
}

/** Sliders for the items of one list, at most. */
const MOST = 24;
/** Steps of a slider, about. */
const STEPS = 400;

/** 1, 2 or 5 times a power of ten: the next at or above. */
export function roof(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  const lead = [1, 2, 5, 10].find((one) => one * power >= value * (1 - 1e-9)) ?? 10;
  return trim(lead * power);
}

/** Without what floating point adds. */
function trim(value: number): number {
  return Number(value.toPrecision(12));
}

/** From where to where a number goes: angles round, shares of a whole, places to both sides, all else from a quarter to twice and more. */
export function span({ number, unit }: Amount, name: string): Span {
  const wide = (least: number, most: number, step = roof((most - least) / STEPS)): Span => ({
    least: trim(step * Math.floor(least / step + 1e-9)),
    most: trim(step * Math.ceil(most / step - 1e-9)),
    step,
  });
  const size = Math.abs(number);
  if (DEGREES.test(unit)) {
    if (size > 360) return wide(number < 0 ? -720 : 0, 720, 1);
    return number < 0 ? wide(-180 * (size > 180 ? 2 : 1), 180, 0.5) : wide(0, 360, 0.5);
  }
  if (RADIANS.test(unit)) return number < 0 ? wide(-7, 7, 0.02) : wide(0, 7, 0.02);
  if (PERCENT.test(unit))
    return wide(number < 0 ? -100 : 0, Math.max(100, roof(2 * size)), size < 5 ? 0.1 : 0.5);
  const placed = number < 0 || PLACED.test(name);
  const reach = size > 0 ? roof(2 * size) : usual(unit);
  if (placed) return wide(-reach, reach);
  if (size === 0) return wide(0, reach);
  const step = roof((reach - size / 4) / STEPS);
  // Never at zero: a stroke or a mass of nothing is no engine.
  return wide(Math.max(step, size / 4), reach, step);
}

/** Where nothing gives a scale: what is usual in its unit. */
function usual(unit: string): number {
  const sizes: Record<string, number> = {
    mm: 100,
    cm: 10,
    m: 0.1,
    in: 4,
    um: 50,
    kg: 1,
    g: 500,
    N: 1000,
    rpm: 1000,
  };
  return sizes[unit.trim()] ?? 10;
}

/** The slider's number as the file is to hold it: on its steps, with the unit that stands there. */
export function writtenBack(number: number, { unit, text }: Amount, step: number): string | number {
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const rounded = Number((Math.round(number / step) * step).toFixed(decimals));
  return text ? `${rounded}${unit}` : rounded;
}

/** A value with one of its numbers in place of another. */
export function replaced(value: unknown, index: number, next: string | number): Json {
  if (!Array.isArray(value)) return next;
  return (value as Json[]).map((item, at) => (at === index ? next : item));
}
