import { expect, test } from "vitest";
import { lines, most, numbersOf, orderName, peak } from "./torsion";

test("the largest value has its place", () => {
  expect(peak([1, 3, 2])).toEqual({ at: 1, value: 3 });
});

test("orders are told as short as they are", () => {
  expect(orderName(4.5)).toBe("order 4.5");
  expect(orderName(3.0000000001)).toBe("order 3");
});

test("a slider reaches some times what the file says, to a round number", () => {
  expect(most(60)).toBe(500);
  expect(most(0.11)).toBeCloseTo(0.5, 12);
  expect(most(0)).toBe(1);
});

test("only what was tried is written", () => {
  expect(lines({})).toEqual([]);
  expect(lines({ damping: 108.58023485 })).toEqual([{ path: "damper.damping", value: "108.58 N m s/rad" }]);
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
