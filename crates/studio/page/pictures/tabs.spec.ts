// Each tab in both themes, on a desk and on a phone.

import { newEngine } from "../tests/page";
import { expect, test } from "../tests/server";
import { draw, into, section, start, tab, THEMES, top, turned } from "./drawn";

for (const theme of THEMES) {
  test.describe(theme, () => {
    test.use({ colorScheme: theme, example: "in-line-3-counterweights.toml" });

    test("engine", async ({ page, studio }) => {
      await start(page, studio.address, theme);
      await page.locator('[data-path="layout.spacing"]').focus();
      await top(page);
      await draw(page, `engine-${theme}`);
    });

    test("3-D view", async ({ page, studio }) => {
      await start(page, studio.address, theme);
      await tab(page, "view");
      await expect(page.locator('[data-stage="drawn"]')).toBeVisible();
      await turned(page, 40);
      await page.getByRole("combobox", { name: "Part" }).selectOption("rod 2");
      await top(page);
      await draw(page, `view-${theme}`);
    });

    test("balance", async ({ page, studio }) => {
      await start(page, studio.address, theme);
      await tab(page, "balance");
      await page.getByRole("button", { name: "Optimise", exact: true }).click();
      const answer = page.getByRole("region", { name: "Optimise" });
      await expect(answer.getByRole("heading", { name: "Optimum found and proved" })).toBeVisible();
      await into(answer);
      await draw(page, `balance-${theme}`);
    });

    test("counterweight", async ({ page, studio }) => {
      await start(page, studio.address, theme);
      await tab(page, "counterweight");
      await page.getByRole("button", { name: "Find the best shape" }).click();
      await expect(page.getByRole("region", { name: "Best shape" })).toContainText("the least mass is");
      await page.getByRole("region", { name: "Best shape" }).getByRole("button", { name: "Adopt" }).click();
      await expect(page.getByRole("table", { name: "Clearances" })).toContainText("kept");
      await top(page);
      await draw(page, `counterweight-${theme}`);
    });

    test("studies", async ({ page, studio }) => {
      await start(page, studio.address, theme);
      await newEngine(page, "V6", "V6, 60 degrees, even firing on pins split by 60 degrees");
      await tab(page, "studies");
      await page.getByRole("textbox", { name: "Bank angles" }).fill("60..120 by 15");
      await page.getByRole("textbox", { name: "Split of pins" }).fill("-60..60 by 30");
      await page.getByRole("button", { name: "Search", exact: true }).click();
      await expect(page.getByRole("table", { name: "Pareto-optimal layouts" })).toBeVisible();
      await page.getByRole("button", { name: "Layout 2", exact: true }).click();
      await into(page.getByRole("form", { name: "Search over layouts" }));
      await draw(page, `studies-${theme}`);
    });

    test("compare", async ({ page, studio }) => {
      await start(page, studio.address, theme);
      await tab(page, "compare");
      await page.getByRole("button", { name: "Pin this state" }).click();
      await page.getByRole("textbox", { name: /Name of the pinned state/ }).fill("as bought");
      await page.keyboard.press("Enter");
      await tab(page, "balance");
      await page.getByRole("button", { name: "Optimise", exact: true }).click();
      const answer = page.getByRole("region", { name: "Optimise" });
      await answer.getByRole("button", { name: "Adopt" }).click();
      await tab(page, "compare");
      await expect(page.getByRole("heading", { name: "Headline numbers" })).toBeVisible();
      await top(page);
      await draw(page, `compare-${theme}`);
    });
  });

  test.describe(`torsional vibration, ${theme}`, () => {
    test.use({
      colorScheme: theme,
      example: "in-line-6-torsion.toml",
      viewport: { width: 1280, height: 1000 },
    });

    test("a damper that is tried", async ({ page, studio }) => {
      await start(page, studio.address, theme);
      await tab(page, "results");
      await section(page, "Torsional vibration");
      await page.getByRole("slider", { name: "Damping" }).fill("20");
      await expect(page.getByRole("button", { name: "As the file says", exact: true })).toBeEnabled();
      await draw(page, `torsion-${theme}`);
    });
  });

  test.describe(`stress, ${theme}`, () => {
    test.use({
      colorScheme: theme,
      example: "single-gas.toml",
      viewport: { width: 1280, height: 1000 },
    });

    test("the crankshaft by finite elements", async ({ page, studio }) => {
      await start(page, studio.address, theme);
      await tab(page, "results");
      await page.getByRole("navigation").getByRole("button", { name: "Stress", exact: true }).click();
      await page.getByRole("button", { name: "Insert typical values" }).click();
      await page.getByLabel("Elements across a fillet").selectOption("2");
      await page.getByLabel("Size of elements").fill("14");
      await page.getByRole("button", { name: "Compute", exact: true }).click();
      const surface = page.getByRole("region", { name: "Stress on the surface" });
      await expect(surface).toBeVisible({ timeout: 240_000 });
      await into(surface);
      await draw(page, `stress-${theme}`);
    });
  });

  test.describe(`results, ${theme}`, () => {
    test.use({ colorScheme: theme, example: "in-line-4-mounts.toml" });

    test("forces, torque, mounts", async ({ page, studio }) => {
      await start(page, studio.address, theme);
      await tab(page, "results");
      await section(page, "Forces and couples");
      await draw(page, `results-${theme}`);
      await section(page, "Torque");
      await draw(page, `torque-${theme}`);
      await section(page, "Mounts");
      await into(page.getByRole("heading", { name: "How the block moves" }));
      await draw(page, `mounts-${theme}`);
    });
  });

  test.describe(`phone, ${theme}`, () => {
    test.use({
      colorScheme: theme,
      example: "in-line-3-counterweights.toml",
      viewport: { width: 390, height: 844 },
      deviceScaleFactor: 2,
      hasTouch: true,
    });

    test("engine, balance, 3-D view, results", async ({ page, studio }) => {
      await start(page, studio.address, theme);
      await draw(page, `phone-engine-${theme}`);
      await tab(page, "view");
      await expect(page.locator('[data-stage="drawn"]')).toBeVisible();
      await turned(page, 40);
      await into(page.locator("[data-stage]"));
      await draw(page, `phone-view-${theme}`);
      await tab(page, "balance");
      await draw(page, `phone-balance-${theme}`);
      await tab(page, "results");
      await section(page, "Forces and couples");
      await into(page.locator("figure[data-plot]").first());
      await draw(page, `phone-results-${theme}`);
    });
  });
}
