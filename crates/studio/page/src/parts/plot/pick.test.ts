import { describe, expect, it } from "vitest";
import { nearest, places, pointAt } from "./pick";
import { pixelMap } from "./scale";
import type { Series } from "./series";

const series = (x: number[], y: number[]): Series => ({ name: "a", x, y, colour: 1 });

describe("readout", () => {
  it("takes the sample next to a place", () => {
    expect(nearest([0, 1, 2, 3], 1.4)).toBe(1);
    expect(nearest([0, 1, 2, 3], 1.6)).toBe(2);
    expect(nearest([0, 1, 2, 3], -9)).toBe(0);
    expect(nearest([0, 1, 2, 3], 9)).toBe(3);
    expect(nearest([5], 9)).toBe(0);
  });
  it("takes the point next to the pointer, within reach", () => {
    const map = pixelMap([0, 1], 0, 1);
    const both = [series([0, 10], [0, 10]), series([20], [20])];
    expect(pointAt(both, map, map, [12, 12])).toEqual({ series: 0, index: 1 });
    expect(pointAt(both, map, map, [40, 40], 5)).toBeUndefined();
  });
  it("walks through the places of all series", () => {
    const x = [0, 1];
    expect(places([series(x, x), series(x, x)])).toBe(x);
    expect(Array.from(places([series([0, 10], [0, 0]), series([2, 10], [0, 0])]))).toEqual([0, 2, 10]);
  });
});
