import { expect, test } from "vitest";
import { lines, most, numbersOf, peak } from "./torsion";

test("the largest value has its place", () => {
  expect(peak([1, 3, 2])).toEqual({ at: 1, value: 3 });
});

test("a slider reaches some times what the file says, to a round number", () => {
  expect(most(60)).toBe(500);
  expect(most(0.11)).toBeCloseTo(0.5, 12);
  expect(most(0)).toBe(1);
});

test("only what was tried is written, in the unit that the file has", () => {
  const none = () => undefined;
  expect(lines({}, none)).toEqual([]);
  expect(lines({ damping: 108.58023485, stiffness: 9000 }, none)).toEqual([
    { path: "damper.damping", value: "108.58 N m s/rad" },
    { path: "damper.stiffness", value: "9000 N m/rad" },
  ]);
  const file = { text: "12.5 lb in2", si: 12.5 * 2.92639653e-4 };
  expect(lines({ ring_inertia: 2 * file.si }, () => file)).toEqual([
    { path: "damper.ring_inertia", value: "25 lb in2" },
  ]);
  // No number that could be scaled: the unit of a file that has none.
  expect(lines({ damping: 60 }, () => ({ text: 5, si: 5 }))).toEqual([
    { path: "damper.damping", value: "60 N m s/rad" },
  ]);
});

test("a damper has the numbers of its kind", () => {
  const damper = {
    kind: "viscous",
    ring_inertia: 0.1,
    hub_inertia: 0.05,
    damping: 60,
    stiffness: 0,
    loss_factor: 0,
  } as const;
  expect(numbersOf(damper)).toEqual(["ring_inertia", "damping"]);
  expect(numbersOf({ ...damper, stiffness: 1e4 })).toEqual(["ring_inertia", "damping", "stiffness"]);
  expect(numbersOf({ ...damper, kind: "rubber", damping: 0, stiffness: 1e4 })).toEqual([
    "ring_inertia",
    "stiffness",
  ]);
});
