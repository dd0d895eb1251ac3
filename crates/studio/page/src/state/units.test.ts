import { describe, expect, it } from "vitest";
import { digits } from "./units.svelte";

describe("numbers for people", () => {
  it("have as many digits as count", () => {
    expect(digits(1234.5)).toBe("1235");
    expect(digits(0.012345)).toBe("0.01235");
    expect(digits(0)).toBe("0");
    expect(digits(NaN)).toBe("–");
  });

  it("have a true minus sign, in the exponent too", () => {
    expect(digits(-127)).toBe("−127.0");
    expect(digits(-1.5e-7, 2)).toBe("−1.5e−7");
    expect(digits(2.5e9, 2)).toBe("2.5e9");
  });
});
