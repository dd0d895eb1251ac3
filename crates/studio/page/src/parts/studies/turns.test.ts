import { expect, test } from "vitest";
import { duration, left } from "./turns.svelte";

test("what is left follows from what was needed so far", () => {
  expect(left(10, 0.25)).toBe(30);
  expect(left(10, 1)).toBe(0);
  expect(left(10, 0)).toBeUndefined();
});

test("times are told in their own unit", () => {
  expect([0.2, 3.2, 130, 9000].map(duration)).toEqual([
    "less than a second",
    "about 4 s",
    "about 2 min",
    "about 3 h",
  ]);
});
