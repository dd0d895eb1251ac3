import { expect, test } from "vitest";
import { sheetOf, withUnit, type Fields } from "./sheet";

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
  displays: [],
  planes: [],
};

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
    planes: [{ name: "front", z: "35", radius: "82" }],
    displays: [
      { z: "0", unbalance: "820", angle: "171" },
      { z: "420", unbalance: "640", angle: "38" },
    ],
  });
  expect(sheet).toContain('[rotor]\nmass = "24 kg"\nsupports = ["0 mm", "420 mm"]');
  expect(sheet).toContain('[[plane]]\nname = "front"\nz = "35 mm"\nradius = "82 mm"');
  expect(sheet.match(/\[\[display\]\]/g)).toHaveLength(2);
});
