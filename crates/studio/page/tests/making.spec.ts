// What the optimiser is told of workshop, purse and production: steps, equal parts, what fits, give-up, budget, speeds, drawn engines.

import type { Page } from "@playwright/test";
import { expect, test } from "./server";

/** The questions that the page asks of the optimiser. */
function questions(page: Page): Record<string, unknown>[] {
  const asked: Record<string, unknown>[] = [];
  page.on("request", (request) => {
    if (request.url().endsWith("/api/balance")) asked.push(request.postDataJSON() as Record<string, unknown>);
  });
  return asked;
}

async function opened(page: Page, address: string) {
  await page.goto(address);
  await page.getByRole("tab", { name: "Balance" }).click();
  await page.getByText("What can be made, cost, speeds, tolerances").click();
}

test.describe("a crank of three", () => {
  test.use({ example: "in-line-3-counterweights.toml" });

  test(
    "steps, equal parts, what fits, give-up, budget and speeds are asked as they are typed",
    { tag: "@server" },
    async ({ studio, page }) => {
      const asked = questions(page);
      await opened(page, studio.address);
      await page.getByRole("textbox", { name: "Weights in steps of" }).fill("2 kg mm");
      await page.getByRole("textbox", { name: "Criteria give up" }).fill("force = 1 %, couple = 5 N m");
      await page.getByRole("textbox", { name: "Budget" }).fill("1000");
      await page.getByRole("textbox", { name: "Speeds" }).fill("1500 rpm, 3000 rpm * 2");
      await page.getByRole("checkbox", { name: "all crank weights are one part" }).check();
      await page.getByRole("checkbox", { name: "no web gets more than fits" }).check();
      await page.getByRole("button", { name: "Optimise", exact: true }).click();
      // Nothing of this engine asks at which speed: that is told, not left out.
      const optimise = page.getByRole("region", { name: "Optimise" });
      await expect(optimise.getByRole("alert")).toContainText("has no effect");
      expect(asked.at(-1)).toMatchObject({ speeds: ["1500 rpm", "3000 rpm * 2"] });
      await page.getByRole("textbox", { name: "Speeds" }).fill("");
      await page.getByRole("button", { name: "Optimise", exact: true }).click();
      await expect(optimise.getByRole("alert")).toContainText("no weight or shaft costs anything");
      expect(asked.at(-1)).toMatchObject({ budget: "1000" });
      await page.getByRole("textbox", { name: "Budget" }).fill("");
      await page.getByRole("button", { name: "Optimise", exact: true }).click();
      await expect(page.getByRole("heading", { name: /Optimum found|Stopped|cannot hold/ })).toBeVisible({
        timeout: 60_000,
      });
      expect(asked.at(-1)).toMatchObject({
        step: "2 kg mm",
        give_up: ["force = 1 %", "couple = 5 N m"],
        budget: null,
        speeds: [],
        equal_parts: true,
        most: "what fits",
        robust: null,
        worst_share: null,
      });
      await expect(page.getByRole("heading", { name: "What fits on the webs" })).toBeVisible();
      // One table tells what it does, every quantity once.
      const table = page.getByRole("table", { name: "Before and after" });
      await expect(table).toHaveCount(1);
      await expect(table.getByText("Force, peak")).toHaveCount(0);
      await expect(table.getByText("Force", { exact: true })).toHaveCount(1);
    },
  );

  test("what cannot be read is refused with its place", async ({ studio, page }) => {
    await opened(page, studio.address);
    await page.getByRole("textbox", { name: "Weights in steps of" }).fill("2 rpm");
    await page.getByRole("button", { name: "Optimise", exact: true }).click();
    await expect(page.getByText(/step/).first()).toBeVisible();
    await expect(page.getByRole("heading", { name: "Optimum found and proved" })).toHaveCount(0);
  });
});

test.describe("a production", () => {
  test.use({ example: "in-line-4-production.toml" });

  test(
    "drawn engines are optimised for, with a limit, and can be stopped",
    { tag: "@server" },
    async ({ studio, page }) => {
      const asked = questions(page);
      await opened(page, studio.address);
      const drawn = page.getByRole("spinbutton", { name: "Engines drawn" });
      await drawn.fill("20");
      await page.getByRole("textbox", { name: "Mean of the worst" }).fill("10 %");
      const optimise = page.getByRole("region", { name: "Optimise" });
      await optimise.getByRole("button", { name: "Add a limit" }).click();
      await optimise.getByRole("textbox", { name: "Limit 1: at most" }).fill("1 kg m");
      await page.getByRole("button", { name: "Optimise", exact: true }).click();
      await expect(page.getByRole("heading", { name: "Optimum found and proved" })).toBeVisible({
        timeout: 60_000,
      });
      expect(asked.at(-1)).toMatchObject({ robust: 20, worst_share: "10 %" });
      await expect(page.locator("pre").filter({ hasText: /20/ }).first()).toBeVisible();
      // A long one does not keep the page waiting.
      await drawn.fill("20000");
      await page.getByRole("button", { name: "Optimise", exact: true }).click();
      await optimise.getByRole("button", { name: "Stop" }).click();
      await expect(page.getByRole("button", { name: "Optimise", exact: true })).toBeEnabled();
      await expect(optimise.getByRole("button", { name: "Stop" })).toHaveCount(0);
    },
  );
});
