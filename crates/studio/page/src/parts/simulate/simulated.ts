// What the page draws of a simulated run.

import { below } from "../../state/rounding";
import type { NamedCurve, SimulationAnswer } from "../../api/types";
import type { Measure } from "../../state/units.svelte";
import type { Rule, Series } from "../plot/series";

/** Every curve over time. */
export function overTime(run: SimulationAnswer, curves: readonly NamedCurve[]): Series[] {
  return curves.map((one, index) => ({ name: one.name, x: run.time, y: one.values, colour: index + 1 }));
}

/** Every curve over the crank angle of the last period, from its start. */
export function overPeriod(run: SimulationAnswer, curves: readonly NamedCurve[]): Series[] {
  const start = run.period_start;
  const first = run.theta[start] ?? 0;
  const theta = run.theta.slice(start).map((angle) => angle - first);
  return curves.map((one, index) => ({
    name: one.name,
    x: theta,
    y: one.values.slice(start),
    colour: index + 1,
  }));
}

/** Curves that are not 0 throughout the last period; all of them where all are. */
export function acting(run: SimulationAnswer, curves: readonly NamedCurve[]): readonly NamedCurve[] {
  const some = curves.filter((one) => one.values.slice(run.period_start).some((value) => value !== 0));
  return some.length > 0 ? some : curves;
}

/** What happened as lines over time; what lies closer than the width of a name shares a line. */
export function eventRules(run: SimulationAnswer): Rule[] {
  const near = 0.1 * (run.time.at(-1) ?? 0);
  const rules: { x: number; name: string }[] = [];
  for (const { time, what } of run.events) {
    const last = rules.at(-1);
    if (last && time - last.x < near) last.name += `, ${what}`;
    else rules.push({ x: time, name: what });
  }
  return rules;
}

/** Curves of the driveline by the number of the inertia that each belongs to. */
export function inertias(curves: readonly NamedCurve[]): NamedCurve[] {
  return curves.map((one) => ({ ...one, name: `inertia ${one.name}` }));
}

/** How a value with a unit of an extreme is shown. */
export function extremeMeasure(unit: string): Measure {
  const measures: Record<string, Measure> = {
    "rad/s": "speed",
    m: "vibration",
    rad: "rotation",
    N: "force",
    "N m": "moment",
  };
  return measures[unit] ?? "none";
}

/** One component of the path of the block's origin, about its mean in the last period [m]. */
export function departure(run: SimulationAnswer, component: 0 | 1 | 2): number[] {
  const last = run.position.slice(run.period_start).map((place) => place[component]);
  const mean = last.reduce((sum, value) => sum + value, 0) / Math.max(1, last.length);
  return run.position.map((place) => place[component] - mean);
}

/** Paths of points across the crank axis in the last period, each about its mean place [m]: y to the right, x up. */
export function orbits(run: SimulationAnswer): Series[] {
  const along = run.theta.slice(run.period_start);
  return run.points.map((point, index) => {
    const path = point.displacement.slice(run.period_start);
    const about = (axis: 0 | 1) => {
      const mean = path.reduce((sum, place) => sum + place[axis], 0) / Math.max(1, path.length);
      return path.map((place) => place[axis] - mean);
    };
    return { name: point.name, x: about(1), y: about(0), along, colour: index + 1 };
  });
}

/** Turn of the block about every axis [rad], for turns that are small. */
export function turn(run: SimulationAnswer, component: 0 | 1 | 2): number[] {
  return run.orientation.map((one) => 2 * (one[component + 1] ?? 0) * Math.sign(one[0] || 1));
}

/** Index of the last sample not after `time`; the first where all are after it. */
export function sampleAt(run: SimulationAnswer, time: number): number {
  let low = 0;
  let high = run.time.length - 1;
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if ((run.time[middle] ?? 0) <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** Fluctuation of the speed in the last period, as a share of its mean. */
export function fluctuation([most, least, mean]: SimulationAnswer["speeds"]): number {
  return mean > 0 ? (most - least) / mean : 0;
}

/** Works and stored energies as two sides of a ledger, largest first: where it comes from and where it goes. */
export function ledger(parts: SimulationAnswer["energy"]): {
  from: SimulationAnswer["energy"];
  to: SimulationAnswer["energy"];
} {
  const rounding = below(...parts.map((part) => part.energy));
  const side = (sign: number) =>
    parts
      .filter((part) => sign * part.energy > rounding)
      .map((part) => ({ ...part, energy: Math.abs(part.energy) }))
      .sort((a, b) => b.energy - a.energy);
  return { from: side(1), to: side(-1) };
}

/** Displacement of the block [m] and its turn as a unit quaternion x, y, z, w: what a picture moves it by. */
export interface BlockPose {
  place: [number, number, number];
  turn: [number, number, number, number];
}

/** Samples beside `time`, and how far it is from the first to the second. */
function beside(run: SimulationAnswer, time: number): [number, number, number] {
  const from = sampleAt(run, time);
  const to = Math.min(from + 1, run.time.length - 1);
  const [start, end] = [run.time[from] ?? 0, run.time[to] ?? 0];
  return [from, to, end > start ? Math.min(1, Math.max(0, (time - start) / (end - start))) : 0];
}

/** Crank angle at `time` [rad]. */
export function thetaAt(run: SimulationAnswer, time: number): number {
  const [from, to, share] = beside(run, time);
  return (run.theta[from] ?? 0) * (1 - share) + (run.theta[to] ?? 0) * share;
}

/** Displacement and turn of the block at `time` from its mean in the last period, `magnification` times as large. */
export function blockAt(run: SimulationAnswer, time: number, magnification: number): BlockPose | null {
  if (run.position.length === 0) return null;
  const [from, to, share] = beside(run, time);
  const at = (values: number[]) =>
    magnification * ((values[from] ?? 0) * (1 - share) + (values[to] ?? 0) * share);
  const mean = (values: number[]) => {
    const last = values.slice(run.period_start);
    return last.reduce((sum, value) => sum + value, 0) / Math.max(1, last.length);
  };
  const axes = [0, 1, 2] as const;
  const place = axes.map((axis) => at(departure(run, axis))) as [number, number, number];
  const turned = axes.map((axis) => {
    const values = turn(run, axis);
    return at(values) - magnification * mean(values);
  });
  const angle = Math.hypot(...turned);
  const factor = angle > 0 ? Math.sin(angle / 2) / angle : 0;
  const [x, y, z] = turned.map((part) => part * factor);
  return { place, turn: [x ?? 0, y ?? 0, z ?? 0, Math.cos(angle / 2)] };
}
