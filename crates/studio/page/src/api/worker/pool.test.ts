import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Answer, Ask, Broken, Start } from "./messages";
import { Pool, type Hand } from "./pool";

/** A worker that answers when the test says so. */
class Stub implements Hand {
  onmessage: ((event: MessageEvent<Answer | Broken>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  asked: Ask[] = [];
  ended = false;

  postMessage(message: Start | Ask) {
    if ("head" in message) this.asked.push(message);
  }

  terminate() {
    this.ended = true;
  }

  say(data: Answer | Broken) {
    this.onmessage?.(new MessageEvent("message", { data }));
  }

  answer(status = 200) {
    this.say({ status, kind: "application/json", bytes: new ArrayBuffer(0) });
  }
}

let stubs: Stub[];
let pool: Pool;

beforeEach(() => {
  stubs = [];
  const hire = () => {
    const stub = new Stub();
    stubs.push(stub);
    return stub;
  };
  pool = new Pool({} as WebAssembly.Module, hire, 2);
});

const statusOf = async (answer: Promise<Answer>) => (await answer).status;

describe("pool", () => {
  it("hires as many as there is work and room for, and no more", async () => {
    const all = ["a", "b", "c"].map((head) => statusOf(pool.ask(head, "")));
    expect(stubs.map((stub) => stub.asked.map((ask) => ask.head))).toEqual([["a"], ["b"]]);
    stubs[1]?.answer();
    expect(stubs[1]?.asked.map((ask) => ask.head)).toEqual(["b", "c"]);
    stubs[0]?.answer();
    stubs[1]?.answer(422);
    expect(await Promise.all(all)).toEqual([200, 200, 422]);
    void pool.ask("d", "");
    expect(stubs).toHaveLength(2);
  });

  it("gives each worker the files once, and again when they changed", () => {
    pool.files = { "a.toml": "1" };
    void pool.ask("a", "");
    stubs[0]?.answer();
    void pool.ask("b", "");
    stubs[0]?.answer();
    pool.files = { "a.toml": "2" };
    void pool.ask("c", "");
    expect(stubs[0]?.asked.map((ask) => ask.files)).toEqual([{ "a.toml": "1" }, null, { "a.toml": "2" }]);
  });

  it("answers an older question of a lane with 409, and ends the worker that computes it", async () => {
    const older = statusOf(pool.ask("a", "", "lane"));
    const newer = statusOf(pool.ask("b", "", "lane"));
    expect(await older).toBe(409);
    expect(stubs[0]?.ended).toBe(true);
    stubs[1]?.answer();
    expect(await newer).toBe(200);
  });

  it("breaks off what is not waited for any more", async () => {
    const stop = new AbortController();
    const asked = pool.ask("a", "", undefined, stop.signal);
    const failed = expect(asked).rejects.toThrow("stopped");
    stop.abort(new Error("stopped"));
    await failed;
    expect(stubs[0]?.ended).toBe(true);
    // Nor does a signal that comes late end anything.
    const late = new AbortController();
    const done = pool.ask("b", "", undefined, late.signal);
    stubs[1]?.answer();
    await done;
    late.abort();
    expect(stubs[1]?.ended).toBe(false);
    // One that waits for a worker is taken out of the row.
    const two = [pool.ask("c", ""), pool.ask("d", "")];
    const waiting = new AbortController();
    const third = expect(pool.ask("e", "", undefined, waiting.signal)).rejects.toThrow();
    waiting.abort();
    await third;
    expect(
      stubs.filter((stub) => !stub.ended).flatMap((stub) => stub.asked.map((ask) => ask.head)),
    ).not.toContain("e");
    expect(two).toHaveLength(2);
  });

  it("replaces a worker that broke off, and says so", async () => {
    const told = vi.spyOn(console, "error").mockReturnValue();
    const asked = pool.ask("a", "");
    stubs[0]?.say({ broken: "unreachable" });
    const answer = await asked;
    expect(answer.status).toBe(500);
    expect(new TextDecoder().decode(answer.bytes)).toContain("the computation broke off");
    expect(stubs[0]?.ended).toBe(true);
    expect(told).toHaveBeenCalledOnce();
    told.mockRestore();
    const next = statusOf(pool.ask("b", ""));
    stubs[1]?.answer();
    expect(await next).toBe(200);
  });
});
