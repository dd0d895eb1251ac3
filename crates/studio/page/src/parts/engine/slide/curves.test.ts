import { describe, expect, it } from "vitest";
import type { Loads } from "../../../api/types";
import { curve, first, series } from "./curves";

/** Loads with these peaks of force and couple. */
function loads(force: number, couple: number): Loads {
  const peak = (value: number) => ({ max: { value, theta: 0 }, min: { value: 0, theta: 0 } });
  const peaks = { force: peak(force), couple: peak(couple), roll_moment: peak(50), shaft_torque: peak(0) };
  const trace = {
    theta: [0, 1],
    force_x: [3, 0],
    force_y: [4, -2],
    couple_x: [0, 0],
    couple_y: [0, 0],
    roll_moment: [-7, 5],
  };
  // Of single parts there are loads, whether or not they cancel.
  const own = { force: peak(2000), couple: peak(2000), roll_moment: peak(50), shaft_torque: peak(50) };
  const parts = [{ part: "reciprocating", loads: { peaks: own } }];
  return { total: { peaks, trace }, parts, cylinders: [] } as unknown as Loads;
}

describe("the curve under a slider", () => {
  it("is what the number acts on first", () => {
    const none = { gas: false, mounts: false };
    const all = { gas: true, mounts: true };
    expect(first("piston.mass", none, loads(1000, 10))).toBe("force");
    expect(first("piston.mass", none, loads(10, 1000))).toBe("couple");
    expect(first("piston.mass", none, loads(1e-9, 1e-9))).toBe("roll");
    expect(first("mount[1].stiffness", all, loads(1, 1))).toBe("mounts");
    expect(first("mount[1].stiffness", none, loads(1000, 1))).toBe("force");
    expect(first("flywheel.inertia", none, undefined)).toBe("speed");
    expect(first("gas.cycle.compression_ratio", all, undefined)).toBe("torque");
    expect(first("piston.bore", all, undefined)).toBe("torque");
    expect(first("piston.bore", none, undefined)).toBe("force");
  });
  it("is the size of a vector, with its peak", () => {
    const found = curve("force", { loads: loads(5, 0) });
    expect(found?.y).toEqual([5, 2]);
    expect(found?.peak).toBe(5);
    expect(curve("roll", { loads: loads(5, 0) })?.peak).toBe(7);
    expect(curve("torque", { loads: loads(5, 0) })).toBeNull();
  });
  it("has the ghost below it", () => {
    const now = { x: [0], y: [1], peak: 1 };
    expect(series(now, now).map(({ name }) => name)).toEqual(["before", "now"]);
    expect(series(now, null).map(({ name }) => name)).toEqual(["now"]);
  });
});
