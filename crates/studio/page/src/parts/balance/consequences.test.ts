import { expect, test } from "vitest";
import type { Consequence, Consequences } from "../../api/types";
import { partName, rows } from "./consequences";

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

test("parts of several crankshafts have its number", () => {
  expect(partName({ kind: "main", crankshaft: 2, main: 1, z: 0 }, true)).toBe("crankshaft 2, main 1");
  expect(partName({ kind: "crankshaft", crankshaft: 1 }, false)).toBe("");
});
