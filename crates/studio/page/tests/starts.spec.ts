// Sections to start from fit every engine of the gallery: a shape is found for each weight, or the limit that would have to give
// way is told, and with that there is one.

import type { APIRequestContext } from "@playwright/test";
import type { Designed, Edit, Reading, Session } from "../src/api/types";
import { eased } from "../src/parts/counterweight/shape/nearest";
import { started, type Ask } from "../src/parts/counterweight/started";
import { expect, test, type Studio } from "./server";

test.use({ example: "" });

/** Asks the server as the page does. */
function asking(studio: Studio, request: APIRequestContext): Ask {
  const { origin } = new URL(studio.address);
  const headers = { "X-Lanchester-Token": studio.token, "X-Lanchester-Client": "starts" };
  return async <T>(path: string, data: unknown) => {
    const answer = await request.post(origin + path, { data, headers });
    expect(answer.ok(), `${path}: ${answer.ok() ? "" : await answer.text()}`).toBe(true);
    return (await answer.json()) as T;
  };
}

test(
  "every engine of the gallery gets outlines, or is told the nearest limit",
  { tag: "@server" },
  async ({ studio, request }) => {
    test.setTimeout(180_000);
    const ask = asking(studio, request);
    const session = await request.get(new URL("/api/session", studio.address).href, {
      headers: { "X-Lanchester-Token": studio.token },
    });
    const { templates } = (await session.json()) as Session;
    expect(templates.length).toBeGreaterThan(40);
    const eases: string[] = [];
    for (const { name, text } of templates) {
      const start = await started(ask, text);
      expect(start.stuck, name).toBeUndefined();
      const { designs } = await ask<Designed>("/api/counterweight/design", { text: start.text, weights: [] });
      expect(designs.weights.length, name).toBeGreaterThan(0);
      const open = designs.weights.filter((weight) => !("found" in weight.outcome));
      if (open.length === 0) continue;
      eases.push(name);
      await expectEased(ask, name, start.text, open);
    }
    console.log(`of ${templates.length} engines a limit has to give way in: ${eases.join(", ")}`);
    expect(eases.length).toBeLessThan(templates.length / 4);
  },
);

/** One of the limits that are told, filled in, makes a shape possible. */
async function expectEased(ask: Ask, name: string, text: string, open: Designed["designs"]["weights"]) {
  const before = await ask<Reading>("/api/engine", { text, edits: [] });
  const value = (path: string) => before.entries.find((entry) => entry.path === path)?.value;
  const edits: Edit[] = open.flatMap((weight) => {
    if ("found" in weight.outcome) return [];
    expect(weight.outcome.infeasible.nearest.length, `${name}: ${weight.name}`).toBeGreaterThan(0);
    const balance = weight.outcome.infeasible.nearest.find((one) => one.limit === "balance");
    return (balance && eased(balance, value, weight.room ?? null)) ?? [];
  });
  expect(edits.length, name).toBe(open.length);
  // The least balance of all of them does for all.
  const least = edits.toSorted((a, b) => parseFloat(String(a.value)) - parseFloat(String(b.value)))[0]!;
  const after = await ask<Reading>("/api/engine", { text, edits: [least] });
  expect(after.engine, `${name}: ${JSON.stringify(after.diagnostics)}`).not.toBeNull();
  const again = await ask<Designed>("/api/counterweight/design", { text: after.text, weights: [] });
  for (const weight of again.designs.weights)
    expect(weight.outcome, `${name}: ${weight.name}`).toHaveProperty("found");
}
