import { describe, expect, it } from "vitest";
import type { PlacedDiagnostic } from "../../../api/types";
import { limitPath, limitsOf, saidAbout, stagesOf, written } from "./criteria";

describe("criteria", () => {
  it("are the same when they are written again", () => {
    const value = [{ couple: "50 N m", force: "1000 N" }, "added unbalance"];
    expect(written(stagesOf(value))).toEqual(value);
    expect(stagesOf(value)).toEqual([
      [
        { criterion: "couple", value: "50 N m" },
        { criterion: "force", value: "1000 N" },
      ],
      [{ criterion: "added unbalance", value: undefined }],
    ]);
    expect(stagesOf(undefined)).toEqual([]);
    expect(written([[], [{ criterion: "force", value: undefined }]])).toEqual(["force"]);
  });

  it("have keys of their own as limits", () => {
    const entry = (path: string, value: string) => ({
      path,
      value,
      span: { start: 0, end: 0 },
      line: 1,
      column: 1,
    });
    const entries = [
      entry("balance.limits.couple", "50 N m"),
      entry('balance.limits."force order 1"', "1 kg"),
    ];
    expect(limitsOf(entries, "balance.limits").map((limit) => [limit.criterion, limit.value])).toEqual([
      ["couple", "50 N m"],
      ["force order 1", "1 kg"],
    ]);
    expect(limitPath("balance.limits", "force order 1")).toBe('balance.limits."force order 1"');
  });

  it("are told apart by what a message points at", () => {
    const text = 'minimise = ["nonsense", { couple = "2 x" }]';
    const at = (words: string) => {
      const start = text.indexOf(words);
      return { span: { start, end: start + words.length } } as PlacedDiagnostic;
    };
    const said = [at('"nonsense"'), at('"2 x"')];
    expect(saidAbout({ criterion: "nonsense", value: undefined }, text, said)).toEqual([said[0]]);
    expect(saidAbout({ criterion: "couple", value: "2 x" }, text, said)).toEqual([said[1]]);
    expect(saidAbout({ criterion: "force", value: undefined }, text, said)).toEqual([]);
  });
});
