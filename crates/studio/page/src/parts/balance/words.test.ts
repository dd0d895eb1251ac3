import { describe, expect, it } from "vitest";
import type { Answer, FoundLimit, FoundStage } from "../../api/types";
import {
  angleWords,
  criterionName,
  gapWords,
  isClosed,
  isWeightedSum,
  measureOf,
  methodWords,
  priceWords,
  ratioName,
} from "./words";

const stage: FoundStage = {
  value: 100,
  lower_bound: 99,
  gap: 1,
  unit: "N",
  terms: [[{ peak: "force" }, 100]],
  term_weights: [1],
  active: [],
};

describe("criteria", () => {
  it("have the names of the file", () => {
    expect(criterionName({ peak: "roll-moment" })).toBe("roll moment");
    expect(criterionName({ order: ["couple", 0.5] })).toBe("couple order 0.5");
    expect(criterionName("added-unbalance")).toBe("added unbalance");
    expect(criterionName({ peak: "largest-main-load" })).toBe("main-bearing load");
    expect(criterionName({ order: [{ "main-load": 2 }, 1] })).toBe("main-bearing load 3 order 1");
    expect(criterionName({ "main-rms": "all" })).toBe("main-bearing load rms");
    expect(criterionName({ "main-rms": { one: 2 } })).toBe("main-bearing load 3 rms");
  });

  it("are measured in their unit", () => {
    expect(measureOf({ peak: "force-x" })).toBe("force");
    expect(measureOf({ order: ["couple", 1] })).toBe("moment");
    expect(measureOf("added-mass")).toBe("mass");
    expect(measureOf({ "main-rms": "largest" })).toBe("force");
  });
});

describe("proofs", () => {
  it("are closed within a part in a million", () => {
    expect(isClosed(stage)).toBe(false);
    expect(gapWords(stage)).toBe("1.0 %");
    expect(gapWords({ ...stage, gap: 1e-6 })).toBe("closed");
    expect(gapWords({ ...stage, value: 0, gap: 0 })).toBe("closed");
  });

  it("tell a weighted sum from a criterion, and the unit of a shadow price", () => {
    const sum: FoundStage = {
      ...stage,
      unit: "1",
      terms: [
        [{ peak: "force" }, 100],
        [{ peak: "couple" }, 5],
      ],
      term_weights: [0.005, 0.1],
    };
    expect([stage, sum].map(isWeightedSum)).toEqual([false, true]);
    const limit: FoundLimit = {
      what: "largest amount of `a`",
      criterion: null,
      side: "at-most",
      unit: "kg m",
      most: 0.01,
      value: 0.01,
      price: 12.34567,
      price_unit: "N per kg m",
      stage: 0,
    };
    const answer = { stages: [stage, sum] } as unknown as Answer;
    expect(priceWords(limit, answer)).toBe(
      "made larger, it lowers the force by 12.35 N per kg m (shadow price).",
    );
    expect(priceWords({ ...limit, stage: 1, price_unit: "1 per kg m" }, answer)).toContain(
      "the weighted sum by 12.35 per kg m",
    );
    expect(priceWords({ ...limit, side: "at-least" }, answer)).toContain("made smaller");
    expect(priceWords({ ...limit, side: "given", price: -2 }, answer)).toContain(
      "made larger, it lowers the force by 2 ",
    );
  });

  it("name each angle once", () => {
    expect(angleWords([Math.PI, 0, Math.PI])).toBe("0°, 180°");
    expect(angleWords([0, 1, 2, 3], 2)).toBe("0°, 57.3° and 2 more");
  });

  it("tell the method", () => {
    expect(methodWords({ kind: "branch-and-bound", nodes: 190, solves: 870 })).toContain(
      "190 branch-and-bound nodes",
    );
    expect(methodWords({ kind: "branch-and-bound", nodes: 13824, solves: 870 })).toContain(
      "13\u202f824 branch-and-bound nodes",
    );
    expect(methodWords({ kind: "convex", solves: 1 })).toContain("1 time ");
  });
});

describe("ratios", () => {
  it("have a sign", () => {
    expect(ratioName(-2)).toBe("−2");
    expect(ratioName(1)).toBe("+1");
  });
});
