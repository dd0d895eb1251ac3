// Where a part of the scene stands at a crank angle: the server's poses, and straight lines between them.

import type { SceneMotion } from "../api/types";

/** Place of a part's frame in the engine's frame [m], and its turn about z [rad]. */
export interface Pose {
  x: number;
  y: number;
  z: number;
  angle: number;
}

/** Value of even steps over a period at the share `at` of it, between its neighbours. */
function between(values: number[], at: number): number {
  const place = at * values.length;
  const from = Math.floor(place) % values.length;
  const to = (from + 1) % values.length;
  const share = place - Math.floor(place);
  return (values[from] ?? 0) * (1 - share) + (values[to] ?? 0) * share;
}

/** `theta` as a share of a period, from 0 up to but not including 1. */
export function phase(theta: number, period: number): number {
  const share = theta / period - Math.floor(theta / period);
  return share < 1 ? share : 0;
}

/** The pose at the crank angle `theta` [rad]; written into `out`, so that moving pictures make no garbage. */
export function pose(motion: SceneMotion, theta: number, out: Pose): Pose {
  out.z = motion.z;
  switch (motion.kind) {
    case "fixed":
      out.x = motion.x;
      out.y = motion.y;
      out.angle = motion.angle;
      break;
    case "turn":
      out.x = motion.x;
      out.y = motion.y;
      out.angle = motion.angle + motion.ratio * theta;
      break;
    case "slide": {
      const travel = between(motion.travel, phase(theta, motion.period));
      out.x = motion.x + travel * Math.cos(motion.angle);
      out.y = motion.y + travel * Math.sin(motion.angle);
      out.angle = motion.angle;
      break;
    }
    case "swing": {
      const at = phase(theta, motion.period);
      out.x = between(motion.x, at);
      out.y = between(motion.y, at);
      out.angle = between(motion.angle, at);
      break;
    }
  }
  return out;
}
