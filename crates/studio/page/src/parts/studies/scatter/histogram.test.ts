import { expect, test } from "vitest";
import type { OutputScatter } from "../../../api/types";
import { histogram, nominal, outline, percentile, shareUpTo } from "./histogram";

const own: OutputScatter = {
  output: "peak-force",
  nominal: 1e-12,
  mean: 5,
  deviation: 2,
  least: 0,
  most: 10,
  most_sample: 3,
  percentile_error: 0,
  capabilities: [],
  contributions: [],
  // As the server gives them: steps first, then those of tables.
  percentiles: [
    { share: 0, value: 0 },
    { share: 0.5, value: 2 },
    { share: 1, value: 10 },
    { share: 0.75, value: 4 },
  ],
};

test("the share up to a value runs straight between percentiles", () => {
  expect([-1, 0, 1, 2, 3, 7, 10, 11].map((value) => shareUpTo(own, value))).toEqual([
    0, 0, 0.25, 0.5, 0.625, 0.875, 1, 1,
  ]);
});

test("bins hold all samples", () => {
  const { edges, shares } = histogram(own, 5);
  expect(edges).toEqual([0, 2, 4, 6, 8, 10]);
  shares.forEach((share, place) =>
    expect(share).toBeCloseTo([0.5, 0.25, 1 / 12, 1 / 12, 1 / 12][place]!, 12),
  );
  expect(outline({ edges: [0, 2, 4], shares: [0.5, 0.25] })).toEqual({
    x: [0, 2, 2, 4],
    y: [0.5, 0.5, 0.25, 0.25],
  });
  expect(histogram({ ...own, most: 0 }).shares).toEqual([]);
});

test("a percentile is one that was asked for, and rounding is no nominal value", () => {
  expect(percentile(own, 0.75)).toBe(4);
  expect(percentile(own, 0.9)).toBeNaN();
  expect(nominal(own, 10)).toBe(0);
  expect(nominal({ ...own, nominal: 0.1 }, 10)).toBe(0.1);
});
