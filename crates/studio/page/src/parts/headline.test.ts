import { describe, expect, it } from "vitest";
import type { Extremes, Loads } from "../api/types";
import { change, figures } from "./headline";

const extremes = (max: number, min = 0): Extremes => ({
  max: { value: max, theta: 0 },
  min: { value: min, theta: 0 },
});
const zero = extremes(0);

function loads(force: number, roll: [number, number]): Loads {
  const peaks = {
    force_x: zero,
    force_y: zero,
    force: extremes(force),
    couple_x: zero,
    couple_y: zero,
    couple: extremes(3e-12),
    roll_moment: extremes(...roll),
    shaft_torque: zero,
  };
  const set = {
    peaks,
    orders: [
      {
        order: 1,
        force_forward: [3, 4],
        force_backward: [0, 2],
        couple_forward: [0, 0],
        couple_backward: [0, 0],
        roll_moment: [0, 0],
        shaft_torque: [0, 0],
      },
    ],
  };
  const cylinder = { ...set, peaks: { ...peaks, force: extremes(1000) } };
  return { total: set, parts: [], cylinders: [{ cylinder: 1, loads: cylinder }] } as unknown as Loads;
}

const named = (given: Loads) =>
  Object.fromEntries(figures(given).map((figure) => [figure.name, figure.value]));

describe("figures", () => {
  it("adds what turns with the crank and against it", () => {
    expect(named(loads(12, [1, -1]))["Force, order 1"]).toBe(7);
  });

  it("has the larger side of the roll moment, and nothing of an order that is not there", () => {
    const got = named(loads(12, [20, -30]));
    expect(got["Roll moment"]).toBe(30);
    expect(got["Force, order 2"]).toBe(0);
  });

  it("calls rounding nothing", () => {
    const got = named(loads(1e-9, [1, -1]));
    expect(got["Peak force"]).toBe(0);
    expect(got["Peak couple"]).toBe(0);
  });

  it("measures rounding by what cancels, devices too", () => {
    const given = loads(1e-5, [1, -1]);
    expect(named(given)["Peak force"]).toBe(1e-5);
    const devices = { ...given.total, peaks: { ...given.total.peaks, force: extremes(1e5) } };
    const parts = [{ loads: devices }] as unknown as Loads["parts"];
    expect(named({ ...given, parts })["Peak force"]).toBe(0);
  });
});

describe("change", () => {
  it.each([
    [100, 88, "−12 %"],
    [100, 101.5, "+1.5 %"],
    [100, 100.001, "same"],
    [0, 0, "same"],
    [0, 3, "new"],
    [3, 0, "gone"],
    [1, 50, "× 50.0"],
  ])("from %d to %d", (before, now, said) => {
    expect(change(before, now)).toBe(said);
  });
});
