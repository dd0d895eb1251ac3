import { describe, expect, it } from "vitest";
import { areaPath, barsPath, dotsPath, headPath, linePath, spacing } from "./path";
import { pixelMap } from "./scale";
import { dashed, type Series } from "./series";

const one = pixelMap([0, 1], 0, 1);
const down = pixelMap([0, 100], 100, 0);

describe("paths", () => {
  it("are rounded to a tenth of a pixel", () => {
    expect(linePath([0, 1.04, 2.06], [0, 1, 2], one, one)).toBe("M0 0L1 1L2.1 2");
  });
  it("break where a value is not finite", () => {
    expect(linePath([0, 1, 2, 3], [0, NaN, 2, 3], one, one)).toBe("M0 0M2 2L3 3");
  });
  it("leave out points on the same pixel, and close", () => {
    expect(linePath([0, 0.01, 5], [0, 0.01, 5], one, one, true)).toBe("M0 0L5 5Z");
  });
  it("go by the logarithm", () => {
    const log = pixelMap([1, 100], 0, 200, true);
    expect(linePath([1, 10, 0], [0, 0, 0], log, one)).toBe("M0 0L100 0");
  });
  it("of bars stand on zero", () => {
    expect(barsPath([10, 20], [40, 0], one, down, 4, 1)).toBe("M9 100V60h4V100Z");
  });
  it("of areas go there and back", () => {
    expect(areaPath([0, 1], [10, 20], [0, 5], one, down)).toBe("M0 90L1 80L1 95L0 100Z");
  });
  it("of arrows end in a head", () => {
    expect(headPath([0, 100], [0, 0], one, one, 10)).toBe("M100 0L90 4L90 -4Z");
    expect(headPath([0, 0], [0, 0], one, one, 10)).toBe("");
  });
  it("of dots are circles", () => {
    expect(dotsPath([5], [50], one, down, 2)).toBe("M3 50a2 2 0 1 0 4 0a2 2 0 1 0 -4 0Z");
  });
});

describe("spacing", () => {
  it("is the least gap over all series", () => {
    expect(
      spacing([
        [0, 1, 2],
        [0.5, 2],
      ]),
    ).toBeCloseTo(0.5);
    expect(spacing([[3]])).toBe(Infinity);
  });
});

describe("curves of one plot", () => {
  const line = (name: string, more: Partial<Series> = {}): Series => ({
    name,
    x: [],
    y: [],
    colour: 3,
    ...more,
  });

  it("differ in their dashes, whatever their colours; the first is drawn through", () => {
    const dashes = dashed(["a", "b", "c", "d", "e", "f", "g"].map((name) => line(name))).map(
      (one) => one.dash,
    );
    expect(dashes[0]).toBeUndefined();
    expect(new Set(dashes).size).toBe(7);
  });

  it("leave dashes that mean something, and what is no curve", () => {
    const ghost = line("before", { dash: "8 3" });
    const bars = line("bars", { kind: "bars" });
    const [one, two, three, four] = dashed([ghost, line("now"), bars, line("other")]);
    expect(one).toBe(ghost);
    expect(two?.dash).toBeUndefined();
    expect(three).toBe(bars);
    expect(four?.dash).toBeTruthy();
    expect(four?.dash).not.toBe("8 3");
  });
});
