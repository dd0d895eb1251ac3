import { expect, test } from "vitest";
import type { Consequence, Consequences } from "../../../api/types";
import { allRows, partName, rows } from "./consequences";

const main = (number: number, before: number, after: number): Consequence => ({
  quantity: "main-load-peak",
  part: { kind: "main", crankshaft: 1, main: number, z: 0 },
  before,
  after,
  change: after > before ? "worse" : "unchanged",
});

const found: Consequences = {
  version: 1,
  speed: 600,
  rows: [
    { quantity: "force", part: { kind: "engine" }, before: 0, after: 0, change: "unchanged" },
    main(1, 5, 5),
    main(2, 5, 9),
    {
      quantity: "balance-rate",
      part: { kind: "bay", crankshaft: 1, bay: 2, between: [0, 0.1] },
      before: 0.8,
      after: 0,
      change: "worse",
    },
  ],
  bending: [],
  dropped: [],
  added: [],
  counterweights: [8, 8],
};

test("rows of nothing are left out, the first of a quantity is marked", () => {
  const shown = rows(found);
  expect(shown.map((row) => row.part)).toEqual(["main 1", "main 2", "mains 2–3"]);
  expect(shown.map((row) => row.first)).toEqual([true, false, true]);
  expect(shown.map((row) => row.change)).toEqual(["unchanged", "worse", "worse"]);
});

test("a choice of quantities is kept", () => {
  expect(rows(found, ["balance-rate"]).map((row) => row.measure)).toEqual(["share"]);
});

test("every quantity is told once, what was asked for first", () => {
  const effects = [
    { criterion: { peak: { "main-load": 1 } }, without: 12, before: 5, after: 9 },
    { criterion: "added-mass", without: 0, before: 2, after: 1 },
    { criterion: { "main-rms": "all" }, without: 3, before: 2, after: 2 },
  ] as const;
  const shown = allRows(effects, found);
  expect(shown.map((row) => [row.name, row.part, row.change])).toEqual([
    ["Main-bearing load 2", "", "worse"],
    ["Added mass", "", "better"],
    ["Main-bearing load rms", "", "unchanged"],
    ["Main-bearing load, peak", "main 1", "unchanged"],
    ["Balance rate", "mains 2–3", "worse"],
  ]);
});

test("parts of several crankshafts have its number", () => {
  expect(partName({ kind: "main", crankshaft: 2, main: 1, z: 0 }, true)).toBe("crankshaft 2, main 1");
  expect(partName({ kind: "crankshaft", crankshaft: 1 }, false)).toBe("");
});
