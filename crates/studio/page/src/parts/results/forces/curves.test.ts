import { describe, expect, it } from "vitest";
import type { Extremes, LoadSet, Loads, OrderLoads } from "../../../api/types";
import { angle, over, path, sets, size, twoSided } from "./curves";
import { noise } from "./magnitude";

const still = (value = 0): Extremes => ({ max: { value, theta: 0 }, min: { value: -value, theta: 0 } });
const order = (number: number, forward: number, backward: number): OrderLoads => ({
  order: number,
  force_forward: [0, forward],
  force_backward: [backward, 0],
  couple_forward: [0, 0],
  couple_backward: [0, 0],
  roll_moment: [0, 0],
  shaft_torque: [0, 0],
});

function set(force: number, couple: number): LoadSet {
  const trace = {
    theta: [0, 1],
    force_x: [force, 0],
    force_y: [0, force / 2],
    couple_x: [0, 0],
    couple_y: [couple, 0],
    roll_moment: [0, 0],
    shaft_torque: [0, 0],
  };
  const peaks = {
    force_x: still(force),
    force_y: still(),
    force: still(force),
    couple_x: still(),
    couple_y: still(),
    couple: still(couple),
    roll_moment: still(),
    shaft_torque: still(),
  };
  return { trace, peaks, orders: [order(0, 5, 0), order(1, 3, 4), order(2, 1, 2)] };
}

const loads = {
  total: set(1e-9, 0),
  parts: [
    { part: "rotating", loads: set(100, 1) },
    { part: "counterweights", loads: set(100, 1) },
  ],
  cylinders: [{ cylinder: 1, loads: set(2000, 0) }],
} as unknown as Loads;

describe("series of loads", () => {
  it("are the whole, then its parts, in colours that stay", () => {
    expect(sets(loads, "whole").map((one) => one.name)).toEqual(["whole engine"]);
    expect(sets(loads, "parts").map((one) => [one.name, one.colour])).toEqual([
      ["whole engine", 1],
      ["rotating", 2],
      ["counterweights", 5],
    ]);
    expect(over(loads, "cylinders", "force_x")[1]?.y).toEqual([2000, 0]);
  });
  it("of paths have y across and x up", () => {
    const [whole] = path(loads, "whole", "force");
    expect(whole?.x).toBe(loads.total.trace.force_y);
    expect(whole?.y).toBe(loads.total.trace.force_x);
    expect(whole?.along).toBe(loads.total.trace.theta);
  });
  it("of spectra have what turns against the crank on the left, the mean between", () => {
    const series = twoSided(loads.total.orders, "force");
    expect(series.map((one) => one.name)).toEqual(["against the crank", "mean", "with the crank"]);
    expect(series[0]?.x).toEqual([-2, -1]);
    expect(series[0]?.y).toEqual([2, 4]);
    expect(series[1]?.y).toEqual([5]);
    expect(series[2]?.y).toEqual([3, 1]);
    expect(twoSided(loads.total.orders, "couple").map((one) => one.name)).not.toContain("mean");
  });
  it("have sizes and directions of complex amplitudes", () => {
    expect(size([3, -4])).toBe(5);
    expect(angle([0, 2])).toBeCloseTo(Math.PI / 2);
  });
});

describe("rounding noise", () => {
  it("is measured by what has to cancel", () => {
    expect(noise(loads).force).toBeCloseTo(2000e-9, 15);
    // A lever of a centimetre, where the parts have no couples worth the name.
    expect(noise(loads).couple).toBeCloseTo(20e-9, 15);
  });
});
