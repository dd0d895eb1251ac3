import { expect, test } from "vitest";
import { place, tornado } from "./tornado";

const number = (name: string) => ({ name, range: "1 mm ± 0.1 mm" });
const output = {
  name: "Peak force",
  unit: "N",
  nominal: 100,
  ends: [
    [99, 101],
    [90, 105],
    [100, 100],
    [null, 120],
  ] as [number | null, number | null][],
};
const answer = { speed: 400, warnings: [], inputs: ["a", "b", "c", "d"].map(number), outputs: [output] };

test("the longest bar is first, and what does nothing is told apart", () => {
  const found = tornado(answer, output);
  expect(found.bars.map(({ name }) => name)).toEqual(["d", "b", "a"]);
  expect(found.idle).toEqual(["c"]);
  expect(found.domain).toEqual([90, 120]);
  expect(found.bars[1]?.share).toBeCloseTo(0.1, 12);
});

test("a share of nothing is none", () => {
  const still = { ...output, nominal: 0, ends: [[0, 5]] as [number | null, number | null][] };
  expect(tornado({ ...answer, inputs: [number("a")] }, still).bars[0]?.share).toBeUndefined();
});

test("values have their places", () => {
  expect(place([90, 120], 105)).toBe(0.5);
  expect(place([1, 1], 1)).toBe(0.5);
});
