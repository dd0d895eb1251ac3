import { expect, test } from "vitest";
import { WIDEST, chief, largest, parameters, sample, width, withNumber } from "./power";

test("a bond with four times the power is twice as wide", () => {
  const most = largest([{ power: [1, -8] }, { power: [2] }]);
  expect(most).toBe(8);
  expect(width(-8, most)).toBe(WIDEST);
  expect(width(2, most)).toBe(WIDEST / 2);
  expect(width(undefined, most)).toBe(0);
  expect(width(1, 0)).toBe(0);
});

test("the cursor stays among the samples", () => {
  expect([sample(0, 11), sample(0.5, 11), sample(1, 11), sample(2, 11)]).toEqual([0, 5, 10, 10]);
  expect(sample(0.5, 0)).toBe(0);
});

const FILE = `name = "a"
[parameters]
m = "1.2 kg"   # a mass
k = "2.5e2 N/m"
w = "sqrt(k/m)"
n = "3"
twice = "2 *m"
[elements]
b = { kind = "I", inertia = "m" }
k2 = "7 N"
`;

test("parameters are the numbers of their section", () => {
  expect(parameters(FILE)).toEqual([
    { name: "m", number: 1.2, unit: "kg" },
    { name: "k", number: 250, unit: "N/m" },
    { name: "n", number: 3, unit: "" },
  ]);
});

test("the graph file is the one that no other uses", () => {
  const part = { name: "mass.toml", text: 'name = "mass"' };
  const whole = { name: "whole.toml", text: '[[use]]\ngraph = "parts/mass.toml"' };
  const table = { name: "push.csv", text: "0,0" };
  expect(chief([table, part, whole])).toBe(whole);
  expect(chief([table])).toBe(undefined);
});

test("one number changes and nothing else", () => {
  const changed = withNumber(FILE, "k", 300);
  expect(changed).toBe(FILE.replace("2.5e2", "300"));
  expect(withNumber(FILE, "k2", 1)).toBe(FILE);
});
