import { expect, test } from "vitest";
import { bySource, gap, largest, width } from "./bars";

const method = (name: string, force: [number, number | null] | null) => ({
  name,
  source: "",
  kind: { of: "matrix" as const },
  left: force && {
    force: { method: force[0], optimum: force[1] },
    couple: { method: 0, optimum: null },
  },
  refused: null,
});

test("bars share the scale of the largest value that a method leaves", () => {
  const all = [method("a", [200, 100]), method("b", [50, null]), method("c", null)];
  expect([largest(all, "force"), largest(all, "couple")]).toEqual([200, 0]);
  expect([width(50, 200), width(0, 0)]).toEqual([25, 0]);
});

test("methods of one source stand together", () => {
  const of = (name: string, source: string) => ({ ...method(name, null), source });
  const groups = bySource([of("a", "one"), of("b", "two"), of("c", "two")]);
  expect(groups.map(({ source, methods }) => [source, ...methods.map(({ name }) => name)])).toEqual([
    ["one", "a"],
    ["two", "b", "c"],
  ]);
});

test("the method furthest from its optimum is named, if one is far", () => {
  expect(gap([method("a", [200, 150]), method("b", [90, 30]), method("c", null)])).toMatch(/“b”.* 67 % less/);
  expect(gap([method("a", [200, 199.9]), method("b", [0, 0])])).toBe("");
});
