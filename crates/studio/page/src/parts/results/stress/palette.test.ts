import { expect, it } from "vitest";
import { roundEnd } from "./palette";

it("ends a scale at a round number that is not below the largest value", () => {
  expect([roundEnd(173), roundEnd(200), roundEnd(0.011), roundEnd(0)]).toEqual([200, 200, 0.012, 1]);
});
