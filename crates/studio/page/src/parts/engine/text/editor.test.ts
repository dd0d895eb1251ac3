import { describe, expect, it } from "vitest";
import { inEditor, inFile, replacement, withEnds } from "./editor";

describe("replacement", () => {
  it.each([
    ["a = 1\nb = 2", "a = 1\nb = 22"],
    ["aaa", "aa"],
    ["aa", "aaa"],
    ["", "x"],
    ["same", "same"],
  ])("from %j to %j", (before, after) => {
    const { from, to, insert } = replacement(before, after);
    expect(before.slice(0, from) + insert + before.slice(to)).toBe(after);
  });

  it("leaves alone what is equal", () => {
    expect(replacement("a = 1\nb = 2", "a = 3\nb = 2")).toEqual({ from: 4, to: 5, insert: "3" });
  });
});

describe("line ends of two signs", () => {
  const file = "a = 1\r\nb = 2\r\nc = 3";
  it("keep places", () => {
    expect(file.slice(14)).toBe("c = 3");
    expect(inEditor(file, 14)).toBe(12);
    expect(inFile(file, 12)).toBe(14);
    expect(inFile("a\nb", 2)).toBe(2);
  });

  it("come back when the editor changed the text", () => {
    expect(withEnds("a\nb", file)).toBe("a\r\nb");
    expect(withEnds("a\nb", "x\ny")).toBe("a\nb");
  });
});
