// What a counterweight must stay clear of, as circles about the crank axis.

import type { BodyClearances, Clearances } from "../../../api/types";
import { obstacleName } from "../words";

export interface Ring {
  name: string;
  /** From the crank axis [m]. */
  radius: number;
  /** Whether it is a wall all around, or the place where a moving part comes nearest. */
  wall: boolean;
  kept: boolean;
}

/**
 * The crankcase, and of the pistons and liners beside this weight the nearest of each kind: the circle through the
 * point of it that the weight comes closest to. Crankshafts beside the origin have none: their axis is not reported.
 */
export function ringsOf(clearances: Clearances | null | undefined, name: string): Ring[] {
  const body = clearances?.bodies.find((one) => one.name === name);
  return body && body.crankshaft === 0 ? ringsAbout(body) : [];
}

function ringsAbout(body: BodyClearances): Ring[] {
  const rings: Ring[] = [];
  for (const kind of ["crankcase", "piston", "liner"] as const) {
    const near = body.clearances.filter((one) => one.obstacle.kind === kind);
    const nearest = near.sort((a, b) => a.distance - b.distance)[0];
    if (!nearest) continue;
    const radius =
      kind === "crankcase"
        ? body.swept_radius + nearest.distance
        : Math.hypot(...planar(nearest.on_obstacle));
    // What is far beyond the case does not help the eye.
    if (rings.some((ring) => radius > 1.4 * ring.radius)) continue;
    rings.push({
      name: obstacleName(nearest.obstacle),
      radius,
      wall: kind === "crankcase",
      kept: nearest.is_kept,
    });
  }
  return rings;
}

function planar([x, y]: [number, number, number]): [number, number] {
  return [x, y];
}
