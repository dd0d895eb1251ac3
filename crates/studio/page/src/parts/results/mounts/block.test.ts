import { describe, expect, it } from "vitest";
import { corners, EDGES, halves, magnified, moved } from "./block";

const box = [0.2, 0.15, 0.3] as const;

describe("the block as a box", () => {
  it("has the moments of inertia that it is made from", () => {
    const mass = 90;
    const [x, y, z] = box.map((half) => (2 * half) ** 2) as [number, number, number];
    const inertia = [(y + z) * 7.5, (z + x) * 7.5, (x + y) * 7.5];
    const found = halves({
      mass,
      inertia: [
        [inertia[0], 0, 0],
        [0, inertia[1], 0],
        [0, 0, inertia[2]],
      ],
    } as never);
    found.forEach((half, index) => expect(half).toBeCloseTo(box[index] ?? 0, 12));
  });

  it("has twelve edges, each along one axis", () => {
    expect(EDGES.length).toBe(12);
    const all = corners(box);
    for (const [from, to] of EDGES) {
      const differ = [0, 1, 2].filter((k) => all[from]?.[k] !== all[to]?.[k]);
      expect(differ.length).toBe(1);
    }
  });

  it("moves as a rigid body for small rotations: u + r x p", () => {
    // A turn about z takes a point on x towards y.
    expect(moved([1, 0, 0], [0, 0, 0, 0, 0, 1], 0.01)).toEqual([1, 0.01, 0]);
    expect(moved([0, 1, 0], [0, 0, 0, 1, 0, 0], 0.01)).toEqual([0, 1, 0.01]);
    expect(moved([0, 0, 1], [0.5, 0, 0, 0, 1, 0], 0.1)).toEqual([0.15000000000000002, 0, 1]);
  });

  it("moves as far on paper whatever the size of the shape", () => {
    const shape = [0.001, 0, 0, 0, 0.002, 0];
    const ten = shape.map((value) => 10 * value);
    expect(magnified(box, ten)).toBeCloseTo(magnified(box, shape) / 10, 9);
    expect(magnified(box, [0, 0, 0, 0, 0, 0])).toBe(0);
  });
});
