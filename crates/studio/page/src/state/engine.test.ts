import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Edit, FileEntry } from "../api/types";
import { engine } from "./engine.svelte";

interface Asked {
  body: { text: string; edits: Edit[] };
  answer: () => Promise<void>;
}

/** What was asked of the server and is not answered yet. */
let asked: Asked[] = [];

/** A server that writes every edit as a line of its own. */
function reading({ text, edits }: Asked["body"]) {
  const lines = edits.map((edit) => `\n${edit.path} = ${String(edit.value)}`);
  const entries: FileEntry[] = [];
  return { text: text + lines.join(""), entries, diagnostics: [], engine: { name: "engine" } };
}

beforeEach(() => {
  asked = [];
  vi.stubGlobal("fetch", (_: string, init: { body: string }) => {
    const body = JSON.parse(init.body) as Asked["body"];
    return new Promise<Response>((answered) => {
      const answer = async () => {
        asked = asked.filter((one) => one.body !== body);
        answered(new Response(JSON.stringify(reading(body))));
        await engineRests();
      };
      asked.push({ body, answer });
    });
  });
});

/** Until everything that follows from an answer has happened. */
const engineRests = () => new Promise((rested) => setTimeout(rested, 5));

async function opened(text: string) {
  const done = engine.open(null, text);
  await asked.at(-1)?.answer();
  await done;
}

describe("engine", () => {
  it("keeps an edit of one engine out of the next", async () => {
    await opened("one");
    void engine.edit([{ path: "rod", value: 1 }], "rod");
    const [late] = asked;
    const done = engine.open(null, "two");
    await late?.answer();
    while (asked.length > 0) await asked[0]?.answer();
    await done;
    expect(engine.text).toBe("two");
    expect(engine.valid).toBe("two");
    expect(engine.undoes).toBeUndefined();
  });

  it("puts an edit into the text that was typed while it was on its way", async () => {
    await opened("one");
    void engine.edit([{ path: "rod", value: 1 }], "rod");
    void engine.set("one and more", "type");
    while (asked.length > 0) await asked[0]?.answer();
    expect(engine.text).toBe("one and more\nrod = 1");
  });

  it("undoes an edit that is still on its way, and that alone", async () => {
    await opened("one");
    void engine.edit([{ path: "a", value: 1 }], "a");
    await asked[0]?.answer();
    void engine.edit([{ path: "b", value: 2 }], "b");
    engine.undo();
    while (asked.length > 0) await asked[0]?.answer();
    expect(engine.text).toBe("one\na = 1");
    engine.undo();
    while (asked.length > 0) await asked[0]?.answer();
    expect(engine.text).toBe("one");
  });

  it("is settled when all edits are read", async () => {
    await opened("one");
    void engine.edit([{ path: "a", value: 1 }], "a");
    void engine.edit([{ path: "b", value: 2 }], "b");
    let settled = false;
    const wait = engine.settled().then(() => (settled = true));
    await asked[0]?.answer();
    expect(settled).toBe(false);
    await asked[0]?.answer();
    await wait;
    expect(engine.text).toBe("one\na = 1\nb = 2");
  });

  it("has something unsaved from the moment of an edit on", async () => {
    await opened("");
    expect(engine.unsaved).toBe(false);
    void engine.edit([{ path: "a", value: 1 }], "a");
    void engine.edit([{ path: "b", value: 2 }], "b");
    expect(engine.unsaved).toBe(true);
    expect(engine.pending.map((edit) => edit.path)).toEqual(["a", "b"]);
    await asked[0]?.answer();
    expect(engine.pending.map((edit) => edit.path)).toEqual(["b"]);
    await asked[0]?.answer();
    expect(engine.pending).toEqual([]);
    expect(engine.unsaved).toBe(true);
  });

  it("remembers the first text that made an engine until another one is opened", async () => {
    await opened("one");
    void engine.set("two", "type");
    await asked[0]?.answer();
    expect(engine.first).toBe("one");
    await opened("three");
    expect(engine.first).toBe("three");
  });
});
