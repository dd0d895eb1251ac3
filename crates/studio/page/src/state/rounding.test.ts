import { describe, expect, it } from "vitest";
import { below, clean, largestMoment } from "./rounding";

describe("the rule of rounding", () => {
  it("takes a billionth of the largest for nothing, and a hair more for something", () => {
    const noise = below(3, -5000, Number.NaN, null);
    expect(noise).toBeCloseTo(5e-6, 15);
    expect(clean(-5e-6, noise)).toBe(0);
    expect(clean(5.1e-6, noise)).toBe(5.1e-6);
    expect(below()).toBe(0);
  });
  it("knows a moment whose parts all vanish by the forces", () => {
    expect(largestMoment(0, 2000)).toBe(20);
    expect(largestMoment(-35, 2000)).toBe(35);
  });
});
