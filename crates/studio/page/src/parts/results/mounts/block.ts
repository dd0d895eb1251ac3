// The block as a box that moves with a rigid-body mode.

import type { MountStudy } from "../../../api/types";

export type Point = readonly [number, number, number];

/** Share of the box by which its corner that moves most is shown to move. */
const SEEN = 0.22;

/** Half sizes of the even box with the mass and the moments of inertia of the body [m]. */
export function halves({ mass, inertia }: MountStudy["body"]): Point {
  const [x, y, z] = [inertia[0][0], inertia[1][1], inertia[2][2]];
  // Ixx = m (b² + c²)/12 and so on round.
  const half = (sum: number) => Math.sqrt(Math.max((6 * sum) / mass, 1e-4)) / 2;
  return [half(y + z - x), half(z + x - y), half(x + y - z)];
}

/** Corners of the box about its centre; bit 0 of the place is x, bit 1 y, bit 2 z. */
export function corners([a, b, c]: Point): Point[] {
  return Array.from({ length: 8 }, (_, place) => [
    place & 1 ? a : -a,
    place & 2 ? b : -b,
    place & 4 ? c : -c,
  ]);
}

/** Pairs of corners that an edge joins. */
export const EDGES: readonly (readonly [number, number])[] = Array.from({ length: 8 }, (_, from) =>
  [1, 2, 4].filter((bit) => !(from & bit)).map((bit) => [from, from | bit] as const),
).flat();

/** Where a point goes with a small displacement of the centre and a small rotation, both times `factor`. */
export function moved([x, y, z]: Point, shape: readonly number[], factor: number): Point {
  const [ux = 0, uy = 0, uz = 0, rx = 0, ry = 0, rz = 0] = shape;
  return [
    x + factor * (ux + ry * z - rz * y),
    y + factor * (uy + rz * x - rx * z),
    z + factor * (uz + rx * y - ry * x),
  ];
}

/** By how much a shape is drawn larger, so that it is seen. */
export function magnified(box: Point, shape: readonly number[]): number {
  const most = Math.max(
    ...corners(box).map((corner) =>
      Math.hypot(...moved(corner, shape, 1).map((at, k) => at - (corner[k] ?? 0))),
    ),
  );
  return most > 0 ? (SEEN * Math.hypot(...box)) / most : 0;
}

/** On paper: z to the lower right, y to the right and up a little, x up. */
export function drawn([x, y, z]: Point, mirrored: boolean): readonly [number, number] {
  const across = mirrored ? -y : y;
  return [0.87 * z + 0.6 * across, 0.3 * z - 0.38 * across - x];
}
