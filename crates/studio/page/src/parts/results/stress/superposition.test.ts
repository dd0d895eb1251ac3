import { describe, expect, it } from "vitest";
import {
  bytesOf,
  displacements,
  fieldOf,
  instantOf,
  largestIn,
  shares,
  sum,
  vonMises,
} from "./superposition";

/** Numbers as the program packs them. */
function packed(components: number[][]) {
  const scales = components.map((values) => Math.max(...values.map(Math.abs)) / 32767);
  const whole = components.flatMap((values, k) =>
    values.map((value) => (scales[k] ? Math.round(value / (scales[k] as number)) : 0)),
  );
  const bytes = new Uint8Array(new Int16Array(whole).buffer);
  return { scales, values: btoa(String.fromCharCode(...bytes)) };
}

/** Two nodes: displacement x, y, z and stress xx, yy, zz, xy, yz, zx. */
const PULL = packed([
  [1e-6, 2e-6],
  [0, 0],
  [3e-6, -1e-6],
  [2e6, 1e6],
  [0, 0],
  [0, 0],
  [0, 0],
  [0, 0],
  [0, 0],
]);
const TWIST = packed([
  [0, 0],
  [4e-6, 0],
  [0, 0],
  [0, 0],
  [0, 0],
  [0, 0],
  [1e6, 3e6],
  [0, 0],
  [0, 0],
]);

describe("superposition", () => {
  it("reads bytes", () => {
    expect([...new Uint8Array(bytesOf("Zm9v"))]).toEqual([102, 111, 111]);
  });

  it("adds up tensors before it takes the equivalent stress", () => {
    const total = sum([fieldOf(PULL), fieldOf(TWIST)], [3, -2], 2);
    const [first, second] = vonMises(total, 2);
    // Tension s and shear t: the root of s^2 + 3 t^2.
    expect(first).toBeCloseTo(Math.hypot(6e6, Math.sqrt(3) * 2e6), -3);
    expect(second).toBeCloseTo(Math.hypot(3e6, Math.sqrt(3) * 6e6), -3);
  });

  it("cancels what is opposite", () => {
    const total = sum([fieldOf(PULL), fieldOf(PULL)], [1, -1], 2);
    for (const left of vonMises(total, 2)) expect(left).toBeLessThan(1);
  });

  it("puts displacements node after node", () => {
    const moved = displacements(sum([fieldOf(PULL), fieldOf(TWIST)], [2, 1], 2), 2);
    const wanted = [2e-6, 4e-6, 6e-6, 4e-6, 0, -2e-6];
    moved.forEach((value, k) => expect(value).toBeCloseTo(wanted[k] as number, 9));
    expect(shares(moved)[0]).toBe(1);
    expect(shares(moved)[1]).toBeLessThan(1);
  });

  it("looks for the largest value in fillets alone, or in one of them", () => {
    const [values, fillets] = [new Float32Array([9, 3, 5, 4]), new Uint16Array([0, 1, 2, 1])];
    expect(largestIn(values, fillets)).toBe(2);
    expect(largestIn(values, fillets, 1)).toBe(3);
    expect(largestIn(new Float32Array([9]), new Uint16Array([0]))).toBeNull();
  });

  it("finds the instant of an angle, whatever turn it is in", () => {
    const period = 4 * Math.PI;
    expect(instantOf(Math.PI, period, 720)).toBe(180);
    expect(instantOf(-Math.PI, period, 720)).toBe(540);
    expect(instantOf(period - 1e-9, period, 720)).toBe(0);
  });
});
