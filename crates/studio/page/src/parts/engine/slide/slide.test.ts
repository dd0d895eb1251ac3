import { describe, expect, it } from "vitest";
import type { KeyInfo } from "../../../api/types";
import { amount, amounts, replaced, roof, span, writtenBack } from "./slide";

const key = (kind: string, choices: string[] = []): KeyInfo => ({
  choices,
  doc: "",
  example: "",
  kind,
  layouts: [],
  name: "",
  required: false,
  wanted: "",
});

describe("a number on a slider", () => {
  it("is taken apart into number and unit", () => {
    expect(amount("86 mm")).toEqual({ number: 86, unit: " mm", text: true });
    expect(amount("-3.5e-2kg m2")).toEqual({ number: -0.035, unit: "kg m2", text: true });
    expect(amount(2)).toEqual({ number: 2, unit: "", text: false });
    for (const word of ["flat", "23/46", "", true, null]) expect(amount(word)).toBeNull();
  });
  it("has one for each number of a list with units, and none for what counts", () => {
    expect(amounts(key("list"), ["0 deg", "180 deg"])).toHaveLength(2);
    expect(amounts(key("quantities"), ["190 N/mm", "170 N/mm", "130 N/mm"])).toHaveLength(3);
    expect(amounts(key("list"), [1, 3, 4, 2])).toEqual([]);
    expect(amounts(key("whole"), 4)).toEqual([]);
    expect(amounts(key("choice", ["2", "4"]), 4)).toEqual([]);
    expect(amounts(undefined, "1 mm")).toEqual([]);
  });
  it("goes round for angles and to both sides for places", () => {
    expect(span(amount("90 deg")!, "bank_angle")).toEqual({ least: 0, most: 360, step: 0.5 });
    expect(span(amount("-20 deg")!, "phase")).toMatchObject({ least: -180, most: 180 });
    expect(span(amount("30 mm")!, "z")).toMatchObject({ least: -100, most: 100 });
    expect(span(amount("0 mm")!, "offset")).toMatchObject({ least: -100, most: 100 });
    expect(span(amount("50 %")!, "share")).toMatchObject({ least: 0, most: 100 });
  });
  it("holds the value and stays above nothing for sizes and masses", () => {
    for (const text of ["86 mm", "0.35 kg", "1.2e-4 kg m2", "350 g", "19 kg", "2000 N/mm"]) {
      const own = amount(text)!;
      const { least, most, step } = span(own, "mass");
      expect(least).toBeGreaterThan(0);
      expect(least).toBeLessThanOrEqual(own.number);
      expect(most).toBeGreaterThanOrEqual(2 * own.number * (1 - 1e-9));
      expect((most - least) / step).toBeGreaterThan(100);
      expect((most - least) / step).toBeLessThan(500);
    }
  });
  it("goes back with its unit, with as many digits as its steps have", () => {
    expect(writtenBack(87.30000001, amount("86 mm")!, 0.5)).toBe("87.5 mm");
    expect(writtenBack(0.3571, amount("0.35kg")!, 0.002)).toBe("0.358kg");
    expect(writtenBack(1.5, amount(2)!, 0.05)).toBe(1.5);
    expect(replaced(["1 mm", "2 mm"], 1, "3 mm")).toEqual(["1 mm", "3 mm"]);
    expect(replaced("1 mm", 0, "3 mm")).toBe("3 mm");
  });
  it("ends at a round number", () => {
    expect([3, 10, 0.21, 172].map(roof)).toEqual([5, 10, 0.5, 200]);
  });
});
