// Loads at a crank angle, read from the traces of the server.

import type { LoadSet, Loads, Trace } from "../api/types";
import { noise } from "../parts/results/forces/magnitude";
import { phase } from "./pose";

export interface Momentary {
  force_x: number;
  force_y: number;
  couple_x: number;
  couple_y: number;
  roll_moment: number;
}

const COMPONENTS = ["force_x", "force_y", "couple_x", "couple_y", "roll_moment"] as const;

/** The loads at `theta` [rad]: straight lines between the samples of the trace. */
export function at(trace: Trace, period: number, theta: number): Momentary {
  const count = trace.theta.length;
  const place = phase(theta, period) * count;
  const from = Math.floor(place) % count;
  const share = place - Math.floor(place);
  const value = (values: number[]) =>
    (values[from] ?? 0) * (1 - share) + (values[(from + 1) % count] ?? 0) * share;
  return Object.fromEntries(COMPONENTS.map((name) => [name, value(trace[name])])) as unknown as Momentary;
}

/** Largest force, couple and roll moment: what arrows are drawn against. */
export function largest({ peaks }: LoadSet): { force: number; couple: number; roll: number } {
  return {
    force: peaks.force.max.value,
    couple: peaks.couple.max.value,
    roll: Math.max(Math.abs(peaks.roll_moment.max.value), Math.abs(peaks.roll_moment.min.value)),
  };
}

/** The parts that have loads at all, with names for people. */
export function sources(loads: Loads): { id: string; name: string; set: LoadSet }[] {
  const least = noise(loads);
  const parts = loads.parts.filter(({ loads: set }) => {
    const { force, couple } = largest(set);
    return force > least.force || couple > least.couple;
  });
  return parts.map(({ part, loads: set }) => ({ id: part, name: nameOf(part), set }));
}

function nameOf(part: string): string {
  const words = part.replaceAll("-", " ");
  const named: Record<string, string> = {
    rotating: "Rotating masses",
    reciprocating: "Reciprocating masses",
    counterweights: "Counterweights",
    shafts: "Balance shafts",
  };
  return named[part] ?? words.charAt(0).toUpperCase() + words.slice(1);
}
