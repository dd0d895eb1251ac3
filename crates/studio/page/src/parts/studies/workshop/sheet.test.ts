import { expect, test } from "vitest";
import { pinsOf, sheetOf, withUnit, type Fields } from "./sheet";

const none: Fields = {
  name: 'the "old" crank',
  pins: 4,
  rods: 2,
  oil: "",
  share: "",
  parts: { big_end: "", bearing: "", small_end: "", piston: "", piston_pin: "", rings: "", locks: "" },
  grade: "",
  speed: "",
  mass: "",
  centre: "",
  displays: [],
  planes: [],
};

test("pins and rods are those of the engine", () => {
  const crank = { angle: 0, z: 0, radius: 0.04, web: 0.02, crankshaft: 0 };
  const cylinder = { number: 1, angle: 0, z: 0, offset: 0, bore: 0, rod: 0.13, knuckle: 0 };
  const on = (places: number[]) => places.map((place) => ({ ...cylinder, throw: place }));
  expect(pinsOf({ throws: [crank, crank], cylinders: on([0, 0, 1, 1]) })).toEqual({ pins: 2, rods: 2 });
  expect(pinsOf({ throws: [crank, crank, crank], cylinders: on([0, 1, 2]) })).toEqual({ pins: 3, rods: 1 });
});

test("plain numbers get the unit of their field, what has one keeps it", () => {
  expect(["370", " 0,4 ", "0.81 lb", ""].map((value) => withUnit(value, "g"))).toEqual([
    "370 g",
    "0.4 g",
    "0.81 lb",
    "",
  ]);
});

test("a sheet has the tables that were filled in", () => {
  expect(sheetOf(none)).toBe('name = "the \\"old\\" crank"\n');
  const parts = { ...none.parts, big_end: "370", small_end: "180", piston: "430" };
  expect(sheetOf({ ...none, parts, oil: "4", share: "50" })).toBe(
    [
      'name = "the \\"old\\" crank"\n',
      '[bobweight]\npins = 4\nrods = 2\noil = "4 g"\nreciprocating_share = "50 %"\n',
      '[parts]\nbig_end = "370 g"\nsmall_end = "180 g"\npiston = "430 g"\n',
    ].join("\n"),
  );
});

test("measurements bring their planes and supports along", () => {
  const sheet = sheetOf({
    ...none,
    mass: "24",
    centre: "290",
    planes: [{ name: "front", z: "35", radius: "82" }],
    displays: [
      { z: "0", unbalance: "820", angle: "171" },
      { z: "420", unbalance: "640", angle: "38" },
    ],
  });
  expect(sheet).toContain('[rotor]\nmass = "24 kg"\ncentre = "290 mm"\nsupports = ["0 mm", "420 mm"]');
  expect(sheet).toContain('[[plane]]\nname = "front"\nz = "35 mm"\nradius = "82 mm"');
  expect(sheet.match(/\[\[display\]\]/g)).toHaveLength(2);
});
