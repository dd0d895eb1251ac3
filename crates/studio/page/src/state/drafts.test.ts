import { describe, expect, it } from "vitest";
import { fate, kept, keyOf, type Draft } from "./drafts.svelte";

const draft: Draft = { text: "mine", edits: [], name: "three.toml", untitled: "three", revision: "a", at: 1 };

describe("drafts", () => {
  it("belong to a folder and a file", () => {
    const keys = [keyOf("/a", "x.toml"), keyOf("/a", null), keyOf("/b", "x.toml")];
    expect(new Set(keys).size).toBe(3);
  });

  it("are read as they were kept, and nothing else is one", () => {
    expect(kept(JSON.stringify(draft))).toEqual(draft);
    const edits = [{ path: "rod.length", value: "155 mm" }];
    expect(kept(JSON.stringify({ ...draft, edits }))).toEqual({ ...draft, edits });
    // As the studio kept them before edits belonged to them.
    expect(kept(JSON.stringify({ ...draft, edits: undefined }))).toEqual(draft);
    for (const no of [null, "", "{", "null", "7", '{"text": 3, "at": 1}']) expect(kept(no)).toBeUndefined();
  });

  it("come back with a reload, over the file that they began from alone", () => {
    expect(fate(draft, true, { revision: "a", text: "theirs" })).toBe("take");
    expect(fate(draft, true, { revision: "b", text: "newer" })).toBe("offer");
    expect(fate(draft, true, null)).toBe("take");
    expect(fate({ ...draft, name: null, revision: null }, true, null)).toBe("take");
  });

  it("of another window are offered, and of no use where the file says the same", () => {
    expect(fate(draft, false, { revision: "a", text: "theirs" })).toBe("offer");
    expect(fate(draft, false, { revision: "b", text: "mine" })).toBe("useless");
    const edits = [{ path: "rod.length", value: "155 mm" }];
    expect(fate({ ...draft, edits }, true, { revision: "a", text: "mine" })).toBe("take");
  });
});
