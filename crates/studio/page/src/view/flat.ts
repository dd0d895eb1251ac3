// The scene as flat outlines, for browsers without WebGL: each part as the convex outline of its projected points.

import type { Scene } from "../api/types";
import { groupOf } from "./groups";
import { type Pose, pose } from "./pose";

export type Side = "front" | "side";
type Point = [number, number];

export interface Outline {
  part: number;
  group: string;
  /** Corners [m]: to the right and up. */
  corners: Point[];
  /** Larger is nearer [m]. */
  depth: number;
}

/** The smallest convex polygon around points, anticlockwise (Andrew's monotone chain). */
export function hull(points: Point[]): Point[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  if (sorted.length < 3) return sorted;
  const half = (ordered: Point[]) => {
    const chain: Point[] = [];
    for (const point of ordered) {
      for (;;) {
        const [a, b] = [chain.at(-2), chain.at(-1)];
        if (!a || !b || (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]) > 0) break;
        chain.pop();
      }
      chain.push(point);
    }
    chain.pop();
    return chain;
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

/** Points of each shape, once each. */
function pointsOf(scene: Scene): [number, number, number][][] {
  return scene.meshes.map(({ positions }) => {
    const points = new Map<string, [number, number, number]>();
    for (let k = 0; k < positions.length; k += 3) {
      const point = positions.slice(k, k + 3) as [number, number, number];
      points.set(point.join(), point);
    }
    return [...points.values()];
  });
}

/** Draws a scene at any angle; the farthest parts come first. */
export class FlatScene {
  readonly #points: [number, number, number][][];
  readonly #at: Pose = { x: 0, y: 0, z: 0, angle: 0 };

  constructor(readonly scene: Scene) {
    this.#points = pointsOf(scene);
  }

  outlines(theta: number, side: Side, hidden: Set<string>): Outline[] {
    const across = this.scene.mirrored ? -1 : 1;
    const outlines = this.scene.parts.flatMap((part, index): Outline[] => {
      const group = groupOf(part.kind).id;
      if (hidden.has(group)) return [];
      const { x, y, z, angle } = pose(part.motion, theta, this.#at);
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      let depth = -Infinity;
      const corners = (this.#points[part.mesh] ?? []).map(([px, py, pz]): Point => {
        const up = x + cos * px - sin * py;
        const right = across * (y + sin * px + cos * py);
        const along = z + pz;
        depth = Math.max(depth, side === "front" ? -along : right);
        return side === "front" ? [right, up] : [along, up];
      });
      return [{ part: index, group, corners: hull(corners), depth }];
    });
    // Bores are glass: they lie over what is in them.
    const rank = (outline: Outline) => (outline.group === "bore" ? 1 : 0);
    return outlines.sort((a, b) => rank(a) - rank(b) || a.depth - b.depth);
  }
}

/** The box around outlines: left, bottom, width, height [m]. */
export function bounds(outlines: Outline[]): [number, number, number, number] {
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of outlines.flatMap((outline) => outline.corners)) {
    left = Math.min(left, x);
    right = Math.max(right, x);
    bottom = Math.min(bottom, y);
    top = Math.max(top, y);
  }
  return left <= right ? [left, bottom, right - left, top - bottom] : [0, 0, 1, 1];
}
