import { describe, expect, it } from "vitest";
import type { LoadSet, OrderLoads } from "../../../api/types";
import { spectrum } from "./spectrum";

type Complex = [number, number];
const zero: Complex = [0, 0];
function order(number: number, forward: Complex, backward: Complex = zero): OrderLoads {
  return {
    order: number,
    force_forward: forward,
    force_backward: backward,
    couple_forward: zero,
    couple_backward: zero,
    roll_moment: zero,
    shaft_torque: zero,
  };
}
const none = { force: 0, couple: 0 };
const set = (orders: OrderLoads[]) => ({ orders }) as LoadSet;

describe("the two-sided spectrum", () => {
  it("takes amounts of complex components", () => {
    const { rows, force } = spectrum(set([order(1, [3, 4], [0, 2])]), undefined, none);
    expect(rows[0]?.force.now).toEqual({ forward: 5, backward: 2 });
    expect(rows[0]?.force.before).toBeUndefined();
    expect(force).toBe(5);
  });

  it("leaves out orders that are nothing, but not the first and second", () => {
    const now = set([order(1, zero), order(2, [100, 0]), order(4, [1, 0]), order(6, [1e-6, 0])]);
    expect(spectrum(now, undefined, none).rows.map((row) => row.order)).toEqual([1, 2, 4]);
  });

  it("shows no rounding as if it were a load", () => {
    const { rows, force } = spectrum(set([order(1, [2e-9, 0], [1e-14, 0])]), undefined, {
      force: 1e-9,
      couple: 0,
    });
    expect(rows[0]?.force.now).toEqual({ forward: 2e-9, backward: 0 });
    expect(force).toBe(2e-9);
  });

  it("shows what was there before", () => {
    const { rows, force } = spectrum(
      set([order(2, [1, 0])]),
      set([order(2, [10, 0]), order(3, [5, 0])]),
      none,
    );
    expect(rows.map((row) => row.order)).toEqual([2, 3]);
    expect(rows[1]?.force).toEqual({ now: { backward: 0, forward: 0 }, before: { backward: 0, forward: 5 } });
    expect(force).toBe(10);
  });
});
