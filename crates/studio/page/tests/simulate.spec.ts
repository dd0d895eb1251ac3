// The Simulate tab: paths of points and torques of gears beside the run.

import type { Page } from "@playwright/test";
import { opened, text } from "./page";
import { expect, test } from "./server";

test.use({ example: "three-cylinder.toml" });

test("the path of a point, and the teeth of the balancer", async ({ studio, page }) => {
  // Teeth need a pressure angle: the file says it.
  const mesh = `\n[[simulation.mesh]]\nshaft = "balancer"\npressure_angle = "20 deg"\nz = "-160 mm"\n`;
  await studio.write((await studio.read()) + mesh);
  await page.goto(studio.address);
  await opened(page);
  await page.getByRole("tab", { name: "Simulate" }).click();
  await page.getByLabel("Length").selectOption("revolutions");
  await page.getByRole("spinbutton", { name: "Revolutions" }).fill("4");
  await page.getByRole("button", { name: "Add a point" }).click();
  await page.getByLabel("x of point 1").fill("350");
  await page.getByLabel("z of point 1").fill("100");
  await page.getByRole("button", { name: "Simulate", exact: true }).click();
  const plots = ["Orbit of 350, 0, 100 mm", "Torques of gears and chains", "Forces of the teeth"];
  for (const title of plots)
    await expect(page.getByText(`${title} in the last period`, { exact: true }).first()).toBeVisible();
  await expect(page.getByText("balancer").first()).toBeVisible();
  // Two of them share a picture; without any there is none.
  await page.getByRole("button", { name: "Add a point" }).click();
  await page.getByRole("button", { name: "Simulate", exact: true }).click();
  // Out of sight a plot keeps what it showed last.
  const orbits = page.getByRole("heading", { name: "Orbits of points of the block in the last period" });
  await orbits.scrollIntoViewIfNeeded();
  await expect(page.getByText("0, 0, 0 mm").first()).toBeVisible();
  await page.getByRole("button", { name: "Remove point 2" }).click();
  await page.getByRole("button", { name: "Remove point 1" }).click();
  await page.getByRole("button", { name: "Simulate", exact: true }).click();
  await expect(page.getByText(/Orbits? of .* in the last period/)).toHaveCount(1);
});

test("the speed at the start is that of the run", async ({ studio, page }) => {
  // Its section [simulation] ends the file.
  const start = 'start = { speed = "3700 rpm", angle = "45 deg" }';
  await studio.write(`${(await studio.read()).trimEnd()}\n${start}\n`);
  await page.goto(studio.address);
  await opened(page);
  await page.getByRole("tab", { name: "Simulate" }).click();
  const speed = page.getByRole("spinbutton", { name: "Speed at the start" });
  await expect(speed).toHaveAttribute("placeholder", "3700");
  await expect(page.getByRole("spinbutton", { name: "Crank angle at the start" })).toHaveAttribute(
    "placeholder",
    "45",
  );
});

test.describe("an engine without a flywheel", () => {
  test.use({ example: "single-gas.toml" });

  test("says what the run needs, and goes on with a typical flywheel", async ({ studio, page }) => {
    await page.goto(studio.address);
    await opened(page);
    await page.getByRole("tab", { name: "Simulate" }).click();
    await page.getByRole("button", { name: "Simulate", exact: true }).click();
    await expect(page.getByRole("heading", { name: "The run needs more of the engine" })).toBeVisible();
    await expect(page.getByText(/^Free speed needs the moment of inertia of/)).toBeVisible();

    await page.getByRole("button", { name: "Add it on the Engine tab" }).click();
    const keys = page.locator("[data-section=flywheel]");
    await expect(keys.getByRole("button", { name: /^Inertia/ })).toBeVisible();
    await page.getByRole("tab", { name: "Simulate" }).click();
    await page.getByRole("button", { name: "Insert typical values" }).click();
    await expect(page.getByText(/in the last period$/).first()).toBeVisible({ timeout: 30_000 });
    await page.getByRole("tab", { name: "Engine" }).click();
    await expect.poll(() => text(page)).toContain("[flywheel]");
  });
});

/** Words of selects for which there is no room. */
function cut(page: Page): Promise<string[]> {
  return page.getByRole("tabpanel").evaluate((panel) => {
    const context = document.createElement("canvas").getContext("2d");
    if (!context) throw new Error("no context");
    return [...panel.querySelectorAll("select")]
      .filter((select) => select.checkVisibility())
      .flatMap((select) => {
        const { font, paddingLeft, paddingRight } = getComputedStyle(select);
        context.font = font;
        // The browser's own arrow is about 20 px wide.
        const room = select.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight) - 20;
        return [...select.options]
          .map((option) => option.text.trim())
          .filter((words) => context.measureText(words).width > room + 1);
      });
  });
}

for (const width of [390, 768, 1440]) {
  test(`at ${width} px no choice is cut, and no tab is wider than the window`, async ({ studio, page }) => {
    await page.setViewportSize({ width, height: 900 });
    await page.goto(studio.address);
    await opened(page);
    await page.getByRole("tab", { name: "Simulate" }).click();
    await expect(page.getByLabel("Length")).toBeVisible();
    expect(await cut(page)).toEqual([]);
    for (const tab of ["Engine", "3-D view", "Balance", "Counterweight", "Results", "Studies", "Compare"]) {
      await page.getByRole("tab", { name: tab, exact: true }).click();
      await page.waitForTimeout(400);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(wide, tab).toBeLessThanOrEqual(width);
    }
  });
}
