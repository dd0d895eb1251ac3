import { describe, expect, it } from "vitest";
import { amplitude } from "./mounts";

describe("amplitude of a turning vector", () => {
  it("is the length where all parts swing together", () => {
    expect(
      amplitude([
        [3, 0],
        [4, 0],
        [0, 0],
      ]),
    ).toBeCloseTo(5);
    expect(
      amplitude([
        [0, 3],
        [0, -4],
        [0, 0],
      ]),
    ).toBeCloseTo(5);
  });
  it("is the radius of a circle", () => {
    expect(
      amplitude([
        [2, 0],
        [0, 2],
        [0, 0],
      ]),
    ).toBeCloseTo(2);
  });
  it("is the largest of all angles", () => {
    const vector: [number, number][] = [
      [1, 0.5],
      [-0.3, 2],
      [0.7, 0.1],
    ];
    let most = 0;
    for (let a = 0; a < Math.PI; a += 1e-4) {
      const size = Math.hypot(...vector.map(([re, im]) => re * Math.cos(a) - im * Math.sin(a)));
      most = Math.max(most, size);
    }
    expect(amplitude(vector)).toBeCloseTo(most, 6);
  });
});
