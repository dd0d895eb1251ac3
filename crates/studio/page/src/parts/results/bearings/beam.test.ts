import { describe, expect, it } from "vitest";
import type { BeamLoads } from "../../../api/types";
import { finely, moment, shear } from "./beam";

const station = (z: number, q: [number, number], m: [number, number]) => ({
  z,
  largest_shear: { value: 10 + z, theta: 0 },
  largest_moment: { value: 20 + z, theta: 0 },
  shear: [q],
  moment: [m],
});
const beam = {
  stations: [station(0, [3, 4], [0, 0]), station(1, [0, 2], [6, 8]), station(3, [0, 0], [0, 0])],
} as unknown as BeamLoads;

describe("shear force", () => {
  it("is constant between planes", () => {
    const [most, now] = shear(beam, 0);
    expect(most?.x).toEqual([0, 1, 1, 3]);
    expect(most?.y).toEqual([10, 10, 11, 11]);
    expect(now?.y).toEqual([5, 5, 2, 2]);
  });
});

describe("bending moment", () => {
  it("runs straight between planes", () => {
    const [most, now] = moment(beam, 0);
    expect(most?.y).toEqual([20, 21, 23]);
    expect(now?.y[4]).toBeCloseTo(5);
    expect(now?.y[8]).toBeCloseTo(10);
    expect(now?.x[now.x.length - 1]).toBe(3);
  });
  it("passes through zero where its direction turns", () => {
    const { values } = finely(
      [0, 1],
      [
        [1, 0],
        [-1, 0],
      ],
    );
    expect(values[4]?.[0]).toBeCloseTo(0);
  });
});
