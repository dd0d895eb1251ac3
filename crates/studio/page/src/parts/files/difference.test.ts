import { describe, expect, it } from "vitest";
import { difference, hunks } from "./difference";

const marked = (before: string, after: string) =>
  difference(before, after).map((line) => line.sign + line.text);

describe("difference", () => {
  it("keeps equal lines and marks the others", () => {
    expect(marked("a\nb\nc", "a\nx\nc")).toEqual([" a", "-b", "+x", " c"]);
    expect(marked("a\nb\nc\nd", "b\nc\ne\nd")).toEqual(["-a", " b", " c", "+e", " d"]);
  });

  it("has nothing to say about equal texts", () => {
    expect(marked("a\nb", "a\nb")).toEqual([" a", " b"]);
    expect(hunks(difference("a\nb", "a\nb"))).toEqual([]);
  });

  it("gives both texts back", () => {
    const before = "k\na\nb\na\nc\n";
    const after = "a\nc\na\nk\nb\n";
    const lines = difference(before, after);
    const of = (sign: string) =>
      lines
        .filter((line) => line.sign !== sign)
        .map((line) => line.text)
        .join("\n");
    expect(of("+")).toBe(before);
    expect(of("-")).toBe(after);
  });

  it("does not fill the memory with long texts that differ throughout", () => {
    const long = (word: string) => Array.from({ length: 5000 }, (_, line) => word + line).join("\n");
    expect(difference(long("a"), long("b"))).toHaveLength(10_000);
  });
});

describe("hunks", () => {
  it("leaves out lines far from a change and counts them", () => {
    const before = "0\n1\n2\n3\n4\n5\n6\n7\n8\n9";
    const found = hunks(difference(before, before.replace("5", "five")), 1);
    expect(found).toHaveLength(1);
    expect(found[0]?.left).toBe(4);
    expect(found[0]?.lines.map((line) => line.sign + line.text)).toEqual([" 4", "-5", "+five", " 6"]);
  });
});
