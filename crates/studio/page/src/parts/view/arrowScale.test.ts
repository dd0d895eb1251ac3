import { beforeEach, describe, expect, it } from "vitest";
import { arrowScale, cut, LONGEST, round } from "./arrowScale.svelte";

beforeEach(() => (arrowScale.reach = undefined));

describe("the scale of arrows", () => {
  it("is a round number above the largest load", () => {
    expect(round(847)).toBe(1000);
    expect(round(1000)).toBe(1000);
    expect(round(0.021)).toBeCloseTo(0.05, 12);
    expect(round(0)).toBe(0);
  });

  it("stays when another engine comes, until it is fitted anew", () => {
    arrowScale.complete({ force: 40, moment: 900 });
    arrowScale.complete({ force: 40_000, moment: 3 });
    expect(arrowScale.reach).toEqual({ force: 50, moment: 1000 });
    arrowScale.fit({ force: 40_000, moment: 3 });
    expect(arrowScale.reach).toEqual({ force: 50_000, moment: 5 });
  });

  it("of a load that there is not comes with the first engine that has it", () => {
    arrowScale.complete({ force: 0, moment: 900 });
    arrowScale.complete({ force: 70, moment: 5 });
    expect(arrowScale.reach).toEqual({ force: 100, moment: 1000 });
  });

  it("ends where the picture ends", () => {
    expect(cut(0.3)).toBe(1);
    expect(4 * cut(4)).toBeCloseTo(LONGEST, 12);
    expect(-4 * cut(-4)).toBeCloseTo(-LONGEST, 12);
  });
});
