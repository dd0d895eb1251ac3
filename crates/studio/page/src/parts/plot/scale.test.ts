import { describe, expect, it } from "vitest";
import { axisTicks, equalised, label, limits, pixelMap, place, valueAt } from "./scale";
import type { Axis, Series } from "./series";

const DEGREE = Math.PI / 180;
const force: Axis = { name: "Force", measure: "force" };
const curve = (y: number[], kind: Series["kind"] = "line"): Series => ({
  name: "a",
  x: y.map((_, i) => i),
  y,
  colour: 1,
  kind,
});

describe("maps", () => {
  it("go there and back", () => {
    const map = pixelMap([-3, 5], 300, 20);
    expect(place(map, -3)).toBeCloseTo(300);
    expect(place(map, 5)).toBeCloseTo(20);
    expect(valueAt(map, place(map, 1.25))).toBeCloseTo(1.25);
    const log = pixelMap([1, 1000], 0, 300, true);
    expect(place(log, 10)).toBeCloseTo(100);
    expect(valueAt(log, 200)).toBeCloseTo(100);
  });
});

describe("limits", () => {
  it("go from tick to tick", () => {
    expect(limits(force, [curve([-37, 83])], "y", 1, 5, true)).toEqual([-40, 100]);
  });
  it("leave out what is not finite", () => {
    expect(limits(force, [curve([NaN, 0, 10, Infinity])], "y", 1, 5, true)).toEqual([0, 10]);
  });
  it("do not blow up rounding noise", () => {
    const axis = { ...force, least: 1e-9 };
    expect(limits(axis, [curve([-1e-12, 4e-12])], "y", 1, 5, true)).toEqual([-1, 1]);
    expect(limits({ ...axis, zero: true }, [curve([0, 4e-12], "bars")], "y", 1, 5, true)).toEqual([0, 1]);
  });
  it("stand on zero for bars", () => {
    expect(limits(force, [curve([40, 90], "bars")], "y", 1, 5, true)[0]).toBe(0);
  });
  it("hold where there is nothing", () => {
    expect(limits(force, [], "y", 1, 5, true)).toEqual([0, 1]);
    const [low, high] = limits(force, [curve([7, 7])], "y", 1, 5, true);
    expect(low).toBeLessThan(7);
    expect(high).toBeGreaterThan(7);
  });
  it("follow the unit", () => {
    // 0.5 kN in lbf is 112.4: the axis ends at a round number of pounds.
    const pound = 4.4482216152605;
    const [, high] = limits(force, [curve([0, 500])], "y", pound, 5, true);
    expect(high / pound).toBeCloseTo(120, 9);
  });
});

describe("equal lengths", () => {
  it("widen the axis that has room", () => {
    const [x, y] = equalised([-1, 1], [-1, 1], 200, 100);
    expect(x).toEqual([-2, 2]);
    expect(y).toEqual([-1, 1]);
  });
});

describe("ticks", () => {
  it("of angles are steps that engineers count in", () => {
    const axis: Axis = { name: "Crank angle", measure: "angle" };
    const ticks = axisTicks([0, 4 * Math.PI], axis, DEGREE, 8);
    expect(ticks.map((tick) => tick.label)).toEqual([
      "0",
      "90",
      "180",
      "270",
      "360",
      "450",
      "540",
      "630",
      "720",
    ]);
    expect(axisTicks([0, 2 * Math.PI], axis, DEGREE, 4).map((tick) => tick.label)).toEqual([
      "0",
      "90",
      "180",
      "270",
      "360",
    ]);
  });
  it("name whole powers on a crowded logarithmic axis", () => {
    const named = axisTicks([1, 1000], { ...force, log: true }, 1, 6).filter((tick) => tick.label !== "");
    expect(named.map((tick) => tick.label)).toEqual(["1", "10", "100", "1000"]);
  });
});

describe("labels", () => {
  it("have the decimals of their step", () => {
    expect(label(0.30000000000000004, 0.1)).toBe("0.3");
    expect(label(-0.25, 0.05)).toBe("−0.25");
    expect(label(1e-17, 0.1)).toBe("0");
  });
  it("group thousands from ten thousand on", () => {
    expect(label(4000, 1000)).toBe("4000");
    expect(label(-40000, 10000)).toBe("−40\u202f000");
  });
  it("take an exponent where zeros would pile up", () => {
    expect(label(2e-9, 1e-9)).toBe("2e−9");
    expect(label(2.5e8, 5e7)).toBe("2.5e8");
  });
  it("name a single whole number", () => {
    const axis = { name: "Cylinder", measure: "none", whole: true } as const;
    expect(axisTicks([0.4, 1.6], axis, 1, 4).map((tick) => tick.label)).toEqual(["1"]);
  });
});
