// Displacement and stress of a surface as the sum of those under unit loads.

import type { PackedField, SurfaceShape } from "../../../api/types";

/** Bytes of a text as RFC 4648 writes them. */
export function bytesOf(text: string): ArrayBuffer {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; k++) bytes[k] = letters.charCodeAt(k);
  return bytes.buffer;
}

/** A surface of triangles. */
export interface Surface {
  /** x, y, z of each node [m]. */
  nodes: Float32Array;
  triangles: Uint32Array;
}

export function surfaceOf(shape: SurfaceShape): Surface {
  return {
    nodes: new Float32Array(bytesOf(shape.nodes)),
    triangles: new Uint32Array(bytesOf(shape.triangles)),
  };
}

/** Values at all nodes, component after component, each times its scale. */
export interface Field {
  scales: readonly number[];
  values: Int16Array;
}

export function fieldOf(packed: PackedField): Field {
  return { scales: packed.scales, values: new Int16Array(bytesOf(packed.values)) };
}

/** Components before those of the stress. */
const MOVED = 3;

/** The sum of fields, each with its weight: component after component. */
export function sum(fields: readonly Field[], weights: readonly number[], count: number): Float32Array {
  const components = fields[0]?.scales.length ?? 0;
  const total = new Float32Array(components * count);
  fields.forEach(({ scales, values }, index) => {
    for (let component = 0; component < components; component++) {
      const factor = (weights[index] ?? 0) * (scales[component] ?? 0);
      if (factor === 0) continue;
      const end = (component + 1) * count;
      for (let k = component * count; k < end; k++)
        total[k] = (total[k] as number) + factor * (values[k] as number);
    }
  });
  return total;
}

/** Displacements, node after node, of a sum [m]. */
export function displacements(total: Float32Array, count: number): Float32Array {
  const moved = new Float32Array(MOVED * count);
  for (let axis = 0; axis < MOVED; axis++)
    for (let k = 0; k < count; k++) moved[MOVED * k + axis] = total[axis * count + k] as number;
  return moved;
}

/** Equivalent stress of von Mises of each node of a sum [Pa]. */
export function vonMises(total: Float32Array, count: number): Float32Array {
  const [xx, yy, zz, xy, yz, zx] = [0, 1, 2, 3, 4, 5].map((k) =>
    total.subarray((MOVED + k) * count, (MOVED + k + 1) * count),
  ) as [Float32Array, Float32Array, Float32Array, Float32Array, Float32Array, Float32Array];
  const equivalent = new Float32Array(count);
  for (let k = 0; k < count; k++) {
    const [x, y, z] = [xx[k] as number, yy[k] as number, zz[k] as number];
    const [a, b, c] = [xy[k] as number, yz[k] as number, zx[k] as number];
    const normal = (x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2;
    equivalent[k] = Math.sqrt(normal / 2 + 3 * (a * a + b * b + c * c));
  }
  return equivalent;
}

/** Size of the displacement of each node over the largest one. */
export function shares(moved: Float32Array): Float32Array {
  const sizes = new Float32Array(moved.length / MOVED);
  for (let k = 0; k < sizes.length; k++)
    sizes[k] = Math.hypot(
      moved[MOVED * k] as number,
      moved[MOVED * k + 1] as number,
      moved[MOVED * k + 2] as number,
    );
  const largest = sizes.reduce((most, size) => Math.max(most, size), 0);
  return largest > 0 ? sizes.map((size) => size / largest) : sizes;
}

/** The node with the largest value, of all fillets or of one, from 1; `null` without such a node. */
export function largestIn(values: Float32Array, filletOf: Uint16Array, fillet?: number): number | null {
  let best: number | null = null;
  for (let k = 0; k < values.length; k++) {
    const own = filletOf[k] as number;
    if (fillet === undefined ? own === 0 : own !== fillet) continue;
    if (best === null || (values[k] as number) > (values[best] as number)) best = k;
  }
  return best;
}

/** Where an angle stands in a list of even steps over a period. */
export function instantOf(theta: number, period: number, count: number): number {
  const place = Math.round((theta / period) * count) % count;
  return place < 0 ? place + count : place;
}
