import { afterEach, describe, expect, it, vi } from "vitest";
import { Gone, Refused, get, post, postForFile } from "./client";

/** An answer that breaks off behind its head, as that of a server that is killed. */
const broken = () =>
  new Response(
    new ReadableStream({
      start(controller) {
        controller.enqueue(new TextEncoder().encode('{"a":'));
        controller.error(new TypeError("network error"));
      },
    }),
  );

afterEach(() => void vi.unstubAllGlobals());

describe("client", () => {
  it("calls a server gone that does not answer, or not to the end", async () => {
    vi.stubGlobal("fetch", () => Promise.reject(new TypeError("failed to fetch")));
    await expect(post("/api/loads", {})).rejects.toBeInstanceOf(Gone);
    vi.stubGlobal("fetch", () => Promise.resolve(broken()));
    await expect(post("/api/loads", {})).rejects.toBeInstanceOf(Gone);
    await expect(postForFile("/api/report", {})).rejects.toBeInstanceOf(Gone);
  });

  it("takes the token that a server started anew has left, and asks once more", async () => {
    const given: string[] = [];
    vi.stubGlobal("fetch", (_: string, { headers }: { headers: Record<string, string> }) => {
      given.push(headers["X-Lanchester-Token"] ?? "");
      const fits = given.at(-1) === "new";
      return Promise.resolve(new Response(fits ? "5" : '{"message":"no"}', { status: fits ? 200 : 401 }));
    });
    await expect(get("/api/session")).rejects.toBeInstanceOf(Refused);
    localStorage.setItem("lanchester-token", "new");
    await expect(get("/api/session")).resolves.toBe(5);
    expect(given.slice(1)).toEqual([given[0], "new"]);
  });

  it("hands on what the server says", async () => {
    const problem = { message: "no", hint: "do this", diagnostics: [] };
    vi.stubGlobal("fetch", () => Promise.resolve(new Response(JSON.stringify(problem), { status: 409 })));
    const refused = await post("/api/file", {}).catch((error: unknown) => error);
    expect(refused).toBeInstanceOf(Refused);
    expect(refused).toMatchObject({ status: 409, problem });
  });
});
