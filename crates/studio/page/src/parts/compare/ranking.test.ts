import { describe, expect, it } from "vitest";
import { factor, sentence } from "./ranking";

const written = (value: number) => `${value} N`;

describe("ranking in words", () => {
  it("goes from the best on", () => {
    const ranking = {
      criterion: "force",
      places: [
        { engine: 1, rank: 1, value: 20 },
        { engine: 0, rank: 2, value: 70 },
      ],
    };
    expect(sentence(ranking as never, ["A", "B"], written)).toBe(
      "B (20 N), then A (70 N, 3.5 times as much).",
    );
  });
  it("puts equals together and does not divide by nothing", () => {
    const ranking = {
      criterion: "couple",
      places: [
        { engine: 0, rank: 1, value: 0 },
        { engine: 2, rank: 1, value: 0 },
        { engine: 1, rank: 3, value: 5 },
      ],
    };
    expect(sentence(ranking as never, ["A", "B", "C"], written)).toBe("A and C (none), then B (5 N).");
  });
  it("says when all are the same", () => {
    const both = (value: number) => ({
      criterion: "force",
      places: [
        { engine: 0, rank: 1, value },
        { engine: 1, rank: 1, value },
      ],
    });
    expect(sentence(both(3) as never, ["A", "B"], written)).toBe("All the same: 3 N.");
    expect(sentence(both(0) as never, ["A", "B"], written)).toBe("None has any.");
  });
  it("writes factors as people say them", () => {
    expect(factor(1.034)).toBe("3.4 % more");
    expect(factor(1.5)).toBe("50 % more");
    expect(factor(67.24)).toBe("67.2 times as much");
    expect(factor(1547)).toBe("1550 times as much");
  });
});
