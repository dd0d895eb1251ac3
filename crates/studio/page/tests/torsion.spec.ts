// Torsional vibration on the Results tab: its pictures, a damper that is tried out, tuned and adopted.

import type { Page } from "@playwright/test";
import type { TorsionAnswer } from "../src/api/types";
import { expect, test, type Studio } from "./server";

async function open(page: Page, studio: Studio) {
  await page.goto(studio.address);
  await page.getByRole("tab", { name: "Results" }).click();
  await page
    .getByRole("navigation", { name: "Kinds of results" })
    .getByRole("button", { name: "Torsional vibration" })
    .click();
}

test.describe("an engine with a damper", () => {
  test.use({ example: "in-line-6-torsion.toml" });

  test(
    "sliders try a damper, the best setting is found and goes into the file",
    { tag: "@server" },
    async ({ studio, page }) => {
      await open(page, studio);
      const facts = page.locator('dl[aria-label="Torsional vibration in short"]');
      await expect(facts).toContainText("Twist, nose to flywheel");
      for (const title of ["Twist between nose and flywheel", "Vibratory shear stress", "Campbell diagram"])
        await expect(page.locator(`figure[data-plot="${title}"]`)).toBeVisible();

      const before = await facts.textContent();
      const damping = page.getByRole("slider", { name: "Damping" });
      await damping.focus();
      await damping.press("Home");
      await expect(facts).not.toHaveText(before ?? "");
      await page.getByRole("button", { name: "As the file says", exact: true }).click();
      await expect(facts).toHaveText(before ?? "");

      await page.getByRole("button", { name: "Find the best setting" }).click();
      await page.getByRole("button", { name: "Try the best" }).click();
      await page.getByRole("button", { name: "Adopt into the engine file" }).click();
      await page.keyboard.press("Control+s");
      await expect.poll(() => studio.read()).not.toContain('damping = "60 N m s/rad"');
      const adopted = /\[damper\][^[]*\ndamping = "([\d.]+) N m s\/rad"/.exec(await studio.read())?.[1];
      expect(Number(adopted)).toBeGreaterThan(60);

      // No other damping has a smaller peak, a twentieth to either side.
      const peak = async (value: number) => {
        const response = await page.request.post(new URL("/api/torsion", studio.address).href, {
          headers: { "X-Lanchester-Token": studio.token },
          data: { text: await studio.read(), damping: value },
        });
        expect(response.ok()).toBe(true);
        return Math.max(...((await response.json()) as TorsionAnswer).twist.total);
      };
      const best = await peak(Number(adopted));
      for (const factor of [0.95, 1.05]) expect(await peak(factor * Number(adopted))).toBeGreaterThan(best);
    },
  );
});

test.describe("an engine without a crankshaft by sizes", () => {
  test.use({ example: "in-line-3.toml" });

  test("says what is missing", async ({ studio, page }) => {
    await open(page, studio);
    await expect(page.getByRole("heading", { name: "There is no torsional vibration yet" })).toBeVisible();
    await expect(page.getByRole("button", { name: "Add it on the Engine tab" })).toBeVisible();
  });
});
