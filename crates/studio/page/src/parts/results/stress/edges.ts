// Sharp edges of a surface: where two of its triangles meet at an angle.

import type { Surface } from "./superposition";

/** Cosine of the angle between two triangles from which on their edge is seen. */
const SHARP = Math.cos((32 * Math.PI) / 180);

/** Pairs of nodes. */
export function sharpEdges({ nodes, triangles }: Surface): Uint32Array {
  const normals = normalsOf(nodes, triangles);
  const count = nodes.length / 3;
  const first = new Map<number, number>();
  const edges: number[] = [];
  for (let triangle = 0; triangle < triangles.length / 3; triangle++) {
    for (let side = 0; side < 3; side++) {
      const a = triangles[3 * triangle + side] as number;
      const b = triangles[3 * triangle + ((side + 1) % 3)] as number;
      const key = Math.min(a, b) * count + Math.max(a, b);
      const other = first.get(key);
      if (other === undefined) first.set(key, triangle);
      else if (dot(normals, triangle, other) < SHARP) edges.push(a, b);
    }
  }
  return new Uint32Array(edges);
}

function dot(normals: Float32Array, a: number, b: number): number {
  let sum = 0;
  for (let k = 0; k < 3; k++) sum += (normals[3 * a + k] as number) * (normals[3 * b + k] as number);
  return sum;
}

/** Outward direction of length 1 of each triangle. */
function normalsOf(nodes: Float32Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(triangles.length);
  const at = (node: number, axis: number) => nodes[3 * node + axis] as number;
  for (let triangle = 0; triangle < triangles.length; triangle += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => triangles[triangle + k] as number) as [number, number, number];
    const [u, v] = [b, c].map((end) => [0, 1, 2].map((axis) => at(end, axis) - at(a, axis))) as [
      [number, number, number],
      [number, number, number],
    ];
    const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]] as const;
    const length = Math.hypot(...cross) || 1;
    cross.forEach((value, k) => (normals[triangle + k] = value / length));
  }
  return normals;
}
