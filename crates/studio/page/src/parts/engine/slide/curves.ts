// The curve that is watched while a number is slid, now and as it was before.

import type { Loads, MountStudy, TorqueReport } from "../../../api/types";
import type { Measure } from "../../../state/units.svelte";
import type { Axis, Series, Values } from "../../plot/series";
import { noise } from "../../results/forces/magnitude";

export type Watched = "force" | "couple" | "roll" | "torque" | "speed" | "mounts";

export const NAMES: Record<Watched, string> = {
  force: "Force on the block",
  couple: "Couple on the block",
  roll: "Roll moment",
  torque: "Torque of the crank",
  speed: "Speed over the cycle",
  mounts: "Largest mount force",
};

/** Which answer of the program has the curve. */
export const SOURCE: Record<Watched, "loads" | "torque" | "mounts"> = {
  force: "loads",
  couple: "loads",
  roll: "loads",
  torque: "torque",
  speed: "torque",
  mounts: "mounts",
};

export interface Answers {
  loads?: Loads | undefined;
  torque?: TorqueReport | undefined;
  mounts?: MountStudy | undefined;
}

export interface Curve {
  x: Values;
  y: Values;
  /** Largest size. */
  peak: number;
}

/** A force counts as much as its couple at about the distance of two cylinders [m]. */
const LEVER = 0.1;

/** What a number acts on first. */
export function first(
  path: string,
  has: { gas: boolean; mounts: boolean },
  loads: Loads | undefined,
): Watched {
  if (has.mounts && /^(mount|block)\b/.test(path)) return "mounts";
  if (/^(flywheel|driveline|load)\b/.test(path)) return "speed";
  if (has.gas && /^(gas|friction|cylinder_head|bore|piston\.bore|crank\.compression)\b|bore$/.test(path))
    return "torque";
  if (!loads) return "force";
  const least = noise(loads);
  const { force, couple } = loads.total.peaks;
  const [pushed, yawed] = [force.max.value, couple.max.value];
  if (pushed > least.force && LEVER * pushed > yawed) return "force";
  return yawed > least.couple ? "couple" : "roll";
}

/** The curve in an answer; none where the answer is not there, or has none. */
export function curve(of: Watched, { loads, torque, mounts }: Answers): Curve | null {
  const sized = (x: Values, y: number[]): Curve => ({ x, y, peak: Math.max(0, ...y.map(Math.abs)) });
  if (SOURCE[of] === "loads") {
    if (!loads) return null;
    const { trace } = loads.total;
    if (of === "roll") return sized(trace.theta, trace.roll_moment);
    const key = of === "force" ? "force" : "couple";
    return sized(
      trace.theta,
      trace[`${key}_x`].map((x, index) => Math.hypot(x, trace[`${key}_y`][index] ?? 0)),
    );
  }
  if (of === "torque") {
    if (!torque) return null;
    const { theta, gas, inertia } = torque.torque;
    return sized(
      theta,
      gas.map((own, index) => own + (inertia[index] ?? 0)),
    );
  }
  if (of === "speed") {
    const ripple = torque?.ripples.find((one) => one.outcome === "periodic");
    if (!ripple || ripple.outcome !== "periodic") return null;
    return sized(
      ripple.theta,
      ripple.speed.map((speed) => speed / ripple.mean_speed - 1),
    );
  }
  if (!mounts) return null;
  const { speeds } = mounts.response;
  return sized(
    speeds.map(({ speed }) => speed),
    speeds.map(({ peaks }) => Math.max(0, ...peaks.map(({ value }) => value))),
  );
}

const MEASURES: Record<Watched, Measure> = {
  force: "force",
  couple: "moment",
  roll: "moment",
  torque: "moment",
  speed: "share",
  mounts: "force",
};

export function axes(of: Watched): { x: Axis; y: Axis } {
  const zero = of === "force" || of === "couple" || of === "mounts";
  return {
    x: of === "mounts" ? { name: "Speed", measure: "speed" } : { name: "Crank angle", measure: "angle" },
    y: { name: NAMES[of], measure: MEASURES[of], zero },
  };
}

/** Now, over the ghost of before: a grey line, dashed. */
export function series(now: Curve | null, before: Curve | null): Series[] {
  const ghost: Series[] = before
    ? [{ name: "before", x: before.x, y: before.y, colour: 6, width: 1.5, dash: "5 4" }]
    : [];
  return now ? [...ghost, { name: "now", x: now.x, y: now.y, colour: 1, width: 2.25 }] : ghost;
}
