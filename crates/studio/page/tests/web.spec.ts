// What only the studio without a server has: nobody is asked, the browser keeps files, and its numbers are those of the program.

import { readFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { Door } from "../src/api/worker/door";
import type { Session } from "../src/api/types";
import { field, opened, text, type } from "./page";
import { Server, expect, test } from "./server";

const WEB = process.env.LANCHESTER_WEB ?? "";
const FOLDER = WEB.endsWith(".html") ? dirname(resolve(WEB)) : resolve(WEB);

test.skip(WEB === "", "LANCHESTER_WEB names no built studio");

test.describe("the page", () => {
  test.use({ example: "in-line-3.toml" });

  test("asks nobody but for its own files", async ({ studio, page }) => {
    const asked: string[] = [];
    page.on("request", (request) => asked.push(request.url()));
    const said: string[] = [];
    page.on("console", (message) => message.type() === "error" && said.push(message.text()));
    page.on("pageerror", (error) => said.push(error.message));
    await page.goto(studio.address);
    await opened(page);
    for (const tab of ["3-D view", "Balance", "Results"]) await page.getByRole("tab", { name: tab }).click();
    await expect(page.locator("figure[data-plot]").first()).toBeVisible();
    const own = new URL(".", studio.address).href;
    const others = asked.filter((address) => !address.startsWith(own) && !/^(blob|data):/.test(address));
    expect(others).toEqual([]);
    expect(asked.filter((address) => address.includes("/api/"))).toEqual([]);
    expect(said).toEqual([]);
  });

  test("opens the last file again, as it was saved", async ({ studio, page }) => {
    await page.goto(studio.address);
    await opened(page);
    await type(page, "rod.length", "155 mm");
    await page.keyboard.press("Control+s");
    await expect(page.getByText("Saved in-line-3.toml")).toBeVisible();
    await page.reload();
    await opened(page);
    await expect(field(page, "rod.length")).toHaveValue("155 mm");
    await expect(page.locator(".unsaved")).toBeHidden();
    await page.getByRole("button", { name: "Open", exact: true }).click();
    const dialog = page.getByRole("dialog", { name: "Open" });
    await expect(dialog.getByRole("heading", { name: "Kept in this browser" })).toBeVisible();
    await expect(dialog.getByRole("button", { name: /in-line-3\.toml/ })).toContainText("open now");
  });

  test("hands out the engine file", async ({ studio, page }) => {
    await page.goto(studio.address);
    await opened(page);
    await type(page, "rod.length", "155 mm");
    await page.getByRole("button", { name: "Share" }).click();
    const waiting = page.waitForEvent("download");
    await page.getByRole("menuitem", { name: /^Download the engine file/ }).click();
    const download = await waiting;
    expect(download.suggestedFilename()).toBe("in-line-3.toml");
    const saved = await readFile(await download.path(), "utf8");
    expect(saved).toContain('length = "155 mm"');
    expect(saved).toBe(await text(page));
  });
});

test.describe("beside the program", () => {
  test.use({ example: "" });

  /** What both answer: method, path, body; the module in this process, the program by its server. */
  async function both() {
    const module = await WebAssembly.compile(await readFile(join(FOLDER, "lanchester.wasm")));
    const door = await Door.open(module);
    const program = await Server.start("");
    const headers = { "X-Lanchester-Token": program.token, "Content-Type": "application/json" };
    return {
      program,
      here: (path: string, body: string) => {
        const answer = door.ask(`POST ${path}`, body);
        return { status: answer.status, bytes: answer.bytes };
      },
      there: async (path: string, body: string) => {
        const answer = await fetch(new URL(path, program.address), { method: "POST", headers, body });
        return { status: answer.status, bytes: await answer.arrayBuffer() };
      },
      templates: JSON.parse(new TextDecoder().decode(door.ask("GET /api/session", "").bytes)) as Session,
    };
  }

  const value = (bytes: ArrayBuffer): unknown => JSON.parse(new TextDecoder().decode(bytes));

  /** Largest number within a value. */
  function size(value: unknown): number {
    if (typeof value === "number") return Math.abs(value);
    if (value === null || typeof value !== "object") return 0;
    return Math.max(0, ...Object.values(value).map(size));
  }

  /** Where two answers differ by more than rounding: forces that cancel leave what the largest number of the answer loses. */
  function differences(a: unknown, b: unknown, scale: number, path: string): string[] {
    if (typeof a === "number" && typeof b === "number")
      return Math.abs(a - b) <= 1e-10 * scale ? [] : [`${path}: ${a} and ${b}, of ${scale}`];
    if (Array.isArray(a) && Array.isArray(b) && a.length === b.length) {
      const own = Math.max(scale, size(a), size(b));
      return a.flatMap((part, at) => differences(part, b[at], own, `${path}[${at}]`));
    }
    if (a && b && typeof a === "object" && typeof b === "object" && !Array.isArray(a) && !Array.isArray(b)) {
      const [left, right] = [a as Record<string, unknown>, b as Record<string, unknown>];
      const keys = Object.keys(left);
      if (keys.join() !== Object.keys(right).join())
        return [`${path}: ${keys.join()} and ${Object.keys(right).join()}`];
      // Where a curve that is flat has its extreme is chance.
      const flat = keys.includes("value") && keys.includes("theta") ? ["theta"] : [];
      return keys
        .filter((key) => !flat.includes(key))
        .flatMap((key) => differences(left[key], right[key], Math.max(scale, size(left)), `${path}.${key}`));
    }
    return a === b ? [] : [`${path}: ${String(a)} and ${String(b)}`];
  }

  test("loads of every engine of the gallery are the program's", async () => {
    test.setTimeout(180_000);
    const { program, here, there, templates } = await both();
    try {
      const all = templates.templates;
      expect(all.length).toBeGreaterThan(40);
      let numbers = 0;
      for (const { name, text } of all) {
        const body = JSON.stringify({ text, samples: 90 });
        const [own, other] = [here("/api/loads", body), await there("/api/loads", body)];
        expect([own.status, other.status], name).toEqual([200, 200]);
        const [a, b] = [value(own.bytes), value(other.bytes)];
        expect(differences(a, b, 0, name).slice(0, 5)).toEqual([]);
        numbers += JSON.stringify(a).length;
      }
      expect(numbers).toBeGreaterThan(1_000_000);
    } finally {
      await program.end();
    }
  });

  test("loads while a slider is dragged take at most twice as long", async ({}, info) => {
    test.setTimeout(180_000);
    const { program, here, there, templates } = await both();
    try {
      const told: string[] = [];
      for (const name of ["in-line-4", "v8-crossplane", "radial-9"]) {
        const engine = templates.templates.find((template) => template.name === name);
        if (!engine) continue;
        const times: { own: number[]; other: number[] } = { own: [], other: [] };
        for (let k = 0; k < 60; k++) {
          const body = JSON.stringify({ text: engine.text, samples: 360, curves: "whole", speed: 200 + k });
          let start = performance.now();
          here("/api/loads", body);
          const own = performance.now() - start;
          start = performance.now();
          await there("/api/loads", body);
          const other = performance.now() - start;
          // The compiler of the browser warms up.
          if (k < 10) continue;
          times.own.push(own);
          times.other.push(other);
        }
        const median = (all: number[]) => all.sort((a, b) => a - b)[Math.floor(all.length / 2)] ?? NaN;
        const [own, other] = [median(times.own), median(times.other)];
        told.push(
          `${name}: ${own.toFixed(2)} ms in the browser's engine, ${other.toFixed(2)} ms by the server`,
        );
        expect(own, told.at(-1)).toBeLessThan(2 * other);
      }
      console.log(told.join("; "));
      await info.attach("times", { body: told.join("\n") });
      expect(told).toHaveLength(3);
    } finally {
      await program.end();
    }
  });
});
