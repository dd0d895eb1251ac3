import { describe, expect, it } from "vitest";
import { apart } from "./labels";

describe("labels", () => {
  it("stay where they are when there is room", () => {
    const labels = [
      { label: "F", x: 0, y: 0 },
      { label: "M", x: 200, y: 3 },
    ];
    expect(apart(labels)).toEqual(labels);
  });
  it("stand below each other when there is none", () => {
    const [first, second, third] = apart([
      { label: "b", x: 10, y: 14 },
      { label: "a", x: 0, y: 10 },
      { label: "c", x: 5, y: 16 },
    ]);
    expect([first?.label, second?.label, third?.label]).toEqual(["a", "b", "c"]);
    expect((second?.y ?? 0) - (first?.y ?? 0)).toBeGreaterThanOrEqual(16);
    expect((third?.y ?? 0) - (second?.y ?? 0)).toBeGreaterThanOrEqual(16);
  });
});
