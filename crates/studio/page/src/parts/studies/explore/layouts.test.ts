import { expect, test } from "vitest";
import { angles, degrees, frontOf, sorted, steps } from "./layouts";

test("angles are lists and ranges in degrees", () => {
  expect(angles(" ")).toBeNull();
  expect(angles("60, 90")?.map(degrees)).toEqual([60, 90]);
  expect(angles("-30..30 by 15, 90")?.map(degrees)).toEqual([-30, -15, 0, 15, 30, 90]);
  for (const wrong of ["60,", "sixty", "90..60 by 15", "0..90 by 0"]) expect(angles(wrong)).toBeUndefined();
});

test("the front of a plane has what no other point beats in both", () => {
  const points = [
    [3, 1],
    [1, 3],
    [2, 2],
    [2, 3],
    [1, 4],
    [3, 1],
  ] as const;
  expect(frontOf(points)).toEqual([1, 2, 0]);
  expect(steps([points[1], points[2], points[0]])).toEqual({ x: [1, 2, 2, 3, 3], y: [3, 3, 2, 2, 1] });
});

test("layouts are sorted both ways, equals by their number", () => {
  const row = (number: number, value: number) => ({
    number,
    case: number,
    name: "",
    throws: [],
    firing_order: null,
    counterweights: "",
    values: [value],
    alike: 1,
  });
  const rows = [row(1, 5), row(2, 3), row(3, 5)];
  const numbers = (by: number | undefined, falling: boolean) =>
    sorted(rows, by, falling).map((one) => one.number);
  expect(numbers(0, false)).toEqual([2, 1, 3]);
  expect(numbers(0, true)).toEqual([1, 3, 2]);
  expect(numbers(undefined, true)).toEqual([3, 2, 1]);
});
