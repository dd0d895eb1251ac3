import { describe, expect, it } from "vitest";
import { cell, table } from "./csv";

const x = { name: "Crank angle", unit: "°", si: 1 };
const y = { name: "Force", unit: "N", si: 1 };

describe("table", () => {
  it("has one column for common places and all digits", () => {
    const theta = [0, 0.1];
    const series = [
      { name: "total", x: theta, y: [0.1 + 0.2, NaN], colour: 1 },
      { name: "part, one", x: theta, y: [1e-12, -2], colour: 2 },
    ];
    expect(table(series, x, y)).toBe(
      'Crank angle [°],total [N],"part, one [N]"\r\n0,0.30000000000000004,1e-12\r\n0.1,,-2\r\n',
    );
  });
  it("has pairs where places differ", () => {
    const series = [
      { name: "a", x: [1], y: [2], colour: 1 },
      { name: "b", x: [3, 4], y: [5, 6], colour: 2 },
    ];
    expect(table(series, x, y).split("\r\n")).toEqual([
      "a: Crank angle [°],a: Force [N],b: Crank angle [°],b: Force [N]",
      "1,2,3,5",
      ",,4,6",
      "",
    ]);
  });
  it("is in the units shown", () => {
    const text = table([{ name: "a", x: [Math.PI], y: [5], colour: 1 }], { ...x, si: Math.PI / 180 }, y);
    expect(text.split("\r\n")[1]).toBe("180,5");
  });
  it("holds no formula", () => {
    expect(cell("=1+1")).toBe("'=1+1");
    expect(cell("@a, b")).toBe('"\'@a, b"');
    expect(cell("-12.5")).toBe("-12.5");
    expect(cell("-bank")).toBe("'-bank");
  });
});
