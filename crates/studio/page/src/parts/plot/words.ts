// Values of axes as they are written.

import { digits, shown, unit } from "../../state/units.svelte";
import type { Axis } from "./series";

export function unitOf(axis: Axis): string {
  return axis.unit ?? unit(axis.measure);
}

/** Name of an axis with its unit. */
export function nameOf(axis: Axis): string {
  const name = unitOf(axis);
  return name ? `${axis.name} [${name}]` : axis.name;
}

/** A value [SI] in the unit of its axis, without the unit's name. */
export function bare(value: number, axis: Axis): string {
  if (axis.whole) return String(Number(value.toFixed(3))).replace("-", "−");
  const inUnit = shown(quiet(value, axis), axis.measure);
  return axis.measure === "angle" ? inUnit.toFixed(1).replace("-", "−") : digits(inUnit);
}

export function written(value: number, axis: Axis): string {
  const name = unitOf(axis);
  return bare(value, axis) + (name === "°" ? "°" : name ? ` ${name}` : "");
}

/** Rounding noise is zero. */
function quiet(value: number, axis: Axis): number {
  return Math.abs(value) < (axis.least ?? 0) ? 0 : value;
}
