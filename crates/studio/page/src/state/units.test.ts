import { describe, expect, it } from "vitest";
import { digits } from "./units.svelte";

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
});
