import { describe, expect, it } from "vitest";
import type { MountStudy } from "../../../api/types";
import { anglesOf, nextSpeed, orbit, overAngle, overSpeed, reach, revolutions, summed } from "./shaken";

type Complex = [number, number];
const none: Complex = [0, 0];

function study(orders: { order: number; motion: Complex[]; moved: Complex[] }[]): MountStudy {
  return {
    response: {
      speeds: [
        { speed: 100, orders },
        { speed: 200, orders },
      ],
    },
    points: [{ displacement: [orders.map(({ moved }) => moved), orders.map(({ moved }) => moved)] }],
  } as unknown as MountStudy;
}
const shaken = study([
  // 2 cos θ along x, 3 sin θ along y, a roll of 0.1 cos θ.
  { order: 1, motion: [[2, 0], [0, -3], none, none, none, [0.1, 0]], moved: [[2, 0], [0, -3], none] },
  // A half order: two revolutions make a period.
  { order: 0.5, motion: [[0.5, 0], none, none, none, none, none], moved: [[0.5, 0], none, none] },
]);
const first = shaken.response.speeds[0];
if (!first) throw new Error("no speed");

describe("the block's motion", () => {
  it("repeats after whole revolutions of all orders", () => {
    expect(revolutions([1, 2, 4])).toBe(1);
    expect(revolutions([0.5, 1])).toBe(2);
    expect(revolutions([1 / 3, 2.5])).toBe(6);
    expect(anglesOf(first).length).toBe(720);
  });

  it("adds orders up with their phases", () => {
    const [sum] = summed([{ order: 2, value: [1, 1] }], [Math.PI / 8]);
    expect(sum).toBeCloseTo(0, 12);
    const [x, y] = overAngle(first, 0);
    expect(x?.y[0]).toBeCloseTo(2.5, 12);
    expect(x?.y[360]).toBeCloseTo(1.5, 12);
    expect(y?.y[90]).toBeCloseTo(3, 12);
    expect(overAngle(first, 3)[2]?.y[180]).toBeCloseTo(-0.1, 12);
  });

  it("goes to and fro by half of its swing", () => {
    const [, y] = overSpeed(shaken, 0);
    expect(y?.y[1]).toBeCloseTo(3, 12);
  });

  it("is told at the computed speed next to the one in view", () => {
    expect(nextSpeed(shaken, 120)).toBe(0);
    expect(nextSpeed(shaken, 170)).toBe(1);
    expect(nextSpeed(shaken, undefined)).toBe(1);
  });
});

describe("the orbit of a mount", () => {
  it("goes from the lateral to the right and the vertical up", () => {
    const [all, ellipse] = orbit(shaken, 0, 0, "front");
    expect(all?.y[0]).toBeCloseTo(2.5, 12);
    expect(all?.x[90]).toBeCloseTo(3, 12);
    expect(ellipse?.name).toBe("order 1");
    // (x/3)² + (y/2)² = 1 all round.
    const { x, y } = ellipse ?? { x: [], y: [] };
    for (let i = 0; i < x.length; i++)
      expect(((x[i] ?? NaN) / 3) ** 2 + ((y[i] ?? NaN) / 2) ** 2).toBeCloseTo(1, 12);
  });

  it("of half an order closes after two revolutions", () => {
    const half = orbit(shaken, 0, 0, "side").find((one) => one.name === "order 0.5");
    expect(half?.along?.[half.along.length - 1]).toBeCloseTo(4 * Math.PI * (359 / 360), 9);
  });

  it("reaches as far as its farthest point", () => {
    expect(reach([orbit(shaken, 0, 0, "front")])).toBeCloseTo(3, 9);
  });
});
