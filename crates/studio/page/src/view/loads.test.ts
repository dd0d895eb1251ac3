import { expect, test } from "vitest";
import { at } from "./loads";

test("loads between two samples lie between them, and the last goes on to the first", () => {
  const trace = {
    theta: [0, 1, 2, 3],
    force_x: [0, 2, 4, 6],
    force_y: [1, 1, 1, 1],
    couple_x: [0, 0, 0, 8],
    couple_y: [0, 0, 0, 0],
    roll_moment: [-1, 1, -1, 1],
    shaft_torque: [0, 0, 0, 0],
  };
  expect(at(trace, 4, 1.5).force_x).toBeCloseTo(3);
  expect(at(trace, 4, 3.5).couple_x).toBeCloseTo(4);
  expect(at(trace, 4, 3.5).force_x).toBeCloseTo(3);
  expect(at(trace, 4, 5).roll_moment).toBeCloseTo(1);
});
