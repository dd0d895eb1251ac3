import { describe, expect, it } from "vitest";
import type { KeyInfo } from "../../../api/types";
import { plain, shownExample, shownTyped, typed, written } from "./written";

const key = (kind: string, wanted: string, example: string): KeyInfo => ({
  name: "key",
  doc: "",
  wanted,
  kind,
  choices: [],
  required: false,
  layouts: [],
  example,
});
const length = key("quantity", "a length with its unit", '"79.5 mm"');
const speed = key(
  "quantity-or-pair",
  "a speed with its unit, or a list of the lowest and the highest",
  '["800 rpm", "4000 rpm"]',
);
const order = key("wholes", "a list of whole numbers", "[1, 3, 4, 2]");
const angles = key("quantities", "a list, each entry an angle with its unit", '["0 deg", "180 deg"]');
const share = key("share", 'a share such as "50 %"', '"50 %"');
const ratio = key("ratio", 'a speed ratio such as -1, 2 or "1/2"', "-1");

describe("written", () => {
  it("leaves quantities as typed", () => {
    expect(written(length, " 3.2 in ")).toBe("3.2 in");
    expect(written(length, "8")).toBe("8");
    expect(written(length, "3,2 mm")).toBe("3,2 mm");
  });

  it("takes one speed or a list of two", () => {
    expect(written(speed, "5000 rpm")).toBe("5000 rpm");
    expect(written(speed, "800 rpm, 6000 rpm")).toEqual(["800 rpm", "6000 rpm"]);
  });

  it("makes lists", () => {
    expect(written(order, "1, 3,4 , 2")).toEqual([1, 3, 4, 2]);
    expect(written(order, "[1, 2]")).toEqual([1, 2]);
    expect(written(order, "1")).toEqual([1]);
    expect(written(angles, '"0 deg", 90 deg,')).toEqual(["0 deg", "90 deg"]);
  });

  it("makes numbers where the file has them", () => {
    expect(written(share, "0.5")).toBe(0.5);
    expect(written(share, "50 %")).toBe("50 %");
    expect(written(ratio, "-2")).toBe(-2);
    expect(written(ratio, "1/2")).toBe("1/2");
    expect(written(ratio, "two")).toBe("two");
  });

  it("gives back what the file holds", () => {
    for (const [info, value] of [
      [length, "3.2 in"],
      [speed, ["800 rpm", "6000 rpm"]],
      [speed, "800 rpm"],
      [order, [1, 3, 2]],
      [share, 0.5],
      [ratio, -1],
    ] as const)
      expect(written(info, typed(value))).toEqual(value);
  });
});

describe("fields", () => {
  it("hold no tables", () => {
    expect(plain(["force order 1", { roll: "3 N m" }])).toBe(false);
    expect(plain([1, 2])).toBe(true);
  });

  it("show examples without the quotes of the file", () => {
    expect(shownExample('["0 deg", "180 deg"]')).toBe("0 deg, 180 deg");
    expect(shownExample("{ order = [1] }")).toBe("");
  });
});

describe("values in fields", () => {
  it("have the digits that count, where they were computed", () => {
    expect(shownTyped("94.54220132 kg mm")).toBe("94.542 kg mm");
    expect(shownTyped("-0.00094542201327 kg m")).toBe("-0.00094542 kg m");
    expect(shownTyped("1234567.891 N/m")).toBe("1234568 N/m");
    expect(shownTyped(["0 deg", "119.999999999 deg"])).toBe("0 deg, 120 deg");
    expect(shownTyped(0.123456789)).toBe("0.12346");
    expect(shownTyped("1.23456789e-5 kg m2")).toBe("1.2346e-5 kg m2");
  });

  it("stay as they are typed", () => {
    for (const text of [
      "88.76 kg mm",
      "101.5995 mm",
      "0.0045 kg m2",
      "12345678 N/m",
      "1/2",
      "10.000 mm",
      "v1.2",
    ])
      expect(shownTyped(text)).toBe(text);
    expect(shownTyped(true)).toBe("true");
  });
});
