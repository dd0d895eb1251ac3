import { describe, expect, it } from "vitest";
import { apart } from "./labels";

describe("labels", () => {
  it("stay where they are when there is room", () => {
    const labels = [
      { label: "F", x: 0, y: 0, left: false },
      { label: "M", x: 200, y: 3, left: false },
    ];
    expect(apart(labels)).toEqual(labels);
  });
  it("do not mind what ends where they begin", () => {
    const labels = [
      { label: "M", x: 100, y: 0, left: true },
      { label: "F", x: 105, y: 2, left: false },
    ];
    expect(apart(labels)).toEqual(labels);
  });
  it("stand below each other when there is none", () => {
    const [first, second, third] = apart([
      { label: "b", x: 10, y: 14, left: false },
      { label: "a", x: 0, y: 10, left: false },
      { label: "c", x: 5, y: 16, left: false },
    ]);
    expect([first?.label, second?.label, third?.label]).toEqual(["a", "b", "c"]);
    expect((second?.y ?? 0) - (first?.y ?? 0)).toBeGreaterThanOrEqual(16);
    expect((third?.y ?? 0) - (second?.y ?? 0)).toBeGreaterThanOrEqual(16);
  });
});
