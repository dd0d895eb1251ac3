import { describe, expect, it } from "vitest";
import { counted, digits, stepped, units } from "./units.svelte";

describe("numbers for people", () => {
  it("have as many digits as count", () => {
    expect(digits(1234.5)).toBe("1235");
    expect(digits(0.012345)).toBe("0.01235");
    expect(digits(0)).toBe("0");
    expect(digits(NaN)).toBe("–");
  });

  it("have thousands apart from ten thousand on, as tables of the program", () => {
    expect(digits(39902.4)).toBe("39\u202f902");
    expect(digits(-123456.7)).toBe("−123\u202f457");
    expect(digits(9876)).toBe("9876");
    expect(digits(0.00012346)).toBe("0.0001235");
  });

  it("have a true minus sign, in the exponent too", () => {
    expect(digits(-127)).toBe("−127.0");
    expect(digits(-1.5e-7, 2)).toBe("−1.5e−7");
    expect(digits(2.5e9, 2)).toBe("2.5e9");
  });

  it("of things are whole, with thousands apart as in all others", () => {
    expect([7, 9824, 13824, 1234567].map(counted)).toEqual([
      "7",
      "9824",
      "13\u202f824",
      "1\u202f234\u202f567",
    ]);
  });

  it("on a slider have the decimals of its steps, in the unit that is chosen", () => {
    units.set("SI");
    expect(stepped(0.0045, "inertia", 4e-5)).toBe("0.00450 kg m²");
    expect(stepped(24000, "angular-stiffness", 100)).toBe("24\u202f000 N m/rad");
    units.set("mm-g");
    expect(stepped(0.0045, "inertia", 4e-5)).toBe("4.50 g m²");
    expect(stepped(60, "angular-damping", 1)).toBe("60 N m s/rad");
    expect(stepped(24000, "angular-stiffness", 100)).toBe("24.0 kN m/rad");
    units.set("US");
    expect(stepped(0.0045, "inertia", 4e-5)).toBe("15.4 lb in²");
    expect(stepped(60, "angular-damping", 1)).toBe("44.3 lbf ft s/rad");
    units.set("mm-g");
  });
});
