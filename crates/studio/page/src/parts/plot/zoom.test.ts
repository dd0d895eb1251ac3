import { describe, expect, it } from "vitest";
import { pixelMap } from "./scale";
import { about, boxed, moved, within, type Zoom } from "./zoom";

const whole: Zoom = { x: [0, 10], y: [-5, 5] };
const maps: [ReturnType<typeof pixelMap>, ReturnType<typeof pixelMap>] = [
  pixelMap(whole.x, 0, 100),
  pixelMap(whole.y, 100, 0),
];

describe("zoom", () => {
  it("keeps the point under the pointer", () => {
    const zoomed = about(maps, whole, [20, 50], 0.5);
    expect(zoomed.x[0]).toBeCloseTo(1);
    expect(zoomed.x[1]).toBeCloseTo(6);
    expect(zoomed.y[0]).toBeCloseTo(-2.5);
  });
  it("moves with the hand", () => {
    const other = moved(maps, { x: [2, 4], y: [0, 1] }, [10, 0]);
    expect(other.x[0]).toBeCloseTo(1);
    expect(other.x[1]).toBeCloseTo(3);
  });
  it("takes a box, a flat one along x alone", () => {
    const both = boxed(maps, whole, [80, 20], [20, 70], false);
    expect(both?.x[0]).toBeCloseTo(2);
    expect(both?.y[0]).toBeCloseTo(-2);
    expect(both?.y[1]).toBeCloseTo(3);
    expect(boxed(maps, whole, [20, 50], [80, 53], false)?.y).toEqual(whole.y);
    expect(boxed(maps, whole, [20, 50], [22, 52], false)).toBeUndefined();
  });
  it("stays inside the whole and says when all is seen", () => {
    expect(within({ x: [-2, 3], y: [-1, 1] }, whole)?.x).toEqual([0, 5]);
    expect(within({ x: [-1, 11], y: [-6, 6] }, whole)).toBeUndefined();
    const least = within({ x: [3, 3], y: [0, 0] }, whole);
    expect((least?.x[1] ?? 0) - (least?.x[0] ?? 0)).toBeGreaterThan(0);
  });
});
