import { describe, expect, it } from "vitest";
import { banded, differ } from "./bands";

describe("a stress with its error band", () => {
  const mega = (stress: number) => stress / 1e6;
  it("has the value that three meshes tend to, and half the width of its band", () => {
    const found = { values: [4.3e8, 4.2e8, 4.15e8], value: 4.12e8, band: 3.75e6, order: 1 };
    expect(banded(found as never, mega)).toBe("412.0 ± 3.8 (0.91 %)");
  });
  it("says where there is none", () => {
    expect(banded(null, mega)).toBe("none");
  });
  it("needs meshes that differ across the fillets", () => {
    expect(differ([{ fillet_elements: 2 }, { fillet_elements: 4 }, { fillet_elements: 6 }])).toBe(true);
    expect(differ([{ fillet_elements: 2 }, { fillet_elements: 2 }, { fillet_elements: 2 }])).toBe(false);
  });
});
