import { describe, expect, it } from "vitest";
import type { FiringChart } from "../../../api/types";
import { strokes } from "./firing";

const chart = {
  period: 4,
  cylinders: [
    {
      cylinder: 2,
      strokes: [
        { stroke: "exhaust", from: 0.5, to: 1.5 },
        { stroke: "power", from: 3.5, to: 4.5 },
      ],
    },
  ],
} as unknown as FiringChart;

describe("bars of strokes", () => {
  it("stand at their cylinder, apart from each other", () => {
    const exhaust = strokes(chart).find((one) => one.name === "exhaust");
    expect(exhaust?.x).toEqual([0.5, 1.5, NaN]);
    expect(exhaust?.y).toEqual([2, 2, NaN]);
    expect(exhaust?.labels?.[1]).toBe("cylinder 2, exhaust ends");
  });
  it("go on at the beginning of the period where they pass its end", () => {
    const power = strokes(chart).find((one) => one.name === "power");
    expect(power?.x).toEqual([3.5, 4, NaN, 0, 0.5, NaN]);
  });
});
