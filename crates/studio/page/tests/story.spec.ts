// The main story of this part of the page: from the gallery to a saved file and its report.

import { readFile } from "node:fs/promises";
import { field, figure, newEngine, opened, text, type } from "./page";
import { expect, test } from "./server";

test.use({ example: "" });

test("from a new in-line three to a saved file and a report", async ({ studio, page }, info) => {
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "three", "in-line three");
  await expect(page.getByRole("heading", { level: 1 })).toContainText("in-line 3");
  const force = await figure(page, "Peak couple").textContent();
  await type(page, "crank.stroke", "3.2 in");
  await type(page, "name", "My three");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("My three");
  await expect(figure(page, "Peak couple")).not.toHaveText(force ?? "");
  await expect(field(page, "crank.stroke")).toHaveValue("3.2 in");

  await page.keyboard.press("Control+s");
  const dialog = page.getByRole("dialog", { name: "Save as" });
  await dialog.getByLabel("Name of the file").fill("my-three");
  await page.keyboard.press("Enter");
  await expect(page.getByText("Saved my-three.toml")).toBeVisible();
  const saved = await studio.read("my-three.toml");
  expect(saved).toBe(await text(page));
  expect(saved).toContain('stroke = "3.2 in"');
  expect(saved).toContain('name = "My three"');

  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Report" }).click();
  const report = info.outputPath("report.html");
  const download = await waiting;
  expect(download.suggestedFilename()).toBe("my-three.html");
  await download.saveAs(report);
  const html = await readFile(report, "utf8");
  expect(html).toContain("My three");
  expect(html).toContain("<svg");
});

test("from a new in-line three to a balanced engine with outlines of its counterweights", async ({
  studio,
  page,
}, info) => {
  const start = Date.now();
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "three", "in-line three");
  const bare = await figure(page, "Couple, order 1").textContent();

  const balance = async (before: string | null) => {
    await page.getByRole("tab", { name: "Balance" }).click();
    await page.getByRole("button", { name: "Optimise", exact: true }).click();
    const answer = page.getByRole("region", { name: "Optimise" });
    await expect(answer.getByRole("heading", { name: "Optimum found and proved" })).toBeVisible();
    await expect(answer.getByRole("button", { name: "Adopt" })).toBeInViewport();
    await answer.getByRole("button", { name: "Adopt" }).click();
    await expect(figure(page, "Couple, order 1")).not.toHaveText(before ?? "");
  };
  await balance(bare);
  const points = await figure(page, "Couple, order 1").textContent();

  await page.getByRole("tab", { name: "Counterweight" }).click();
  await page.getByRole("button", { name: "Add all to start from" }).click();
  await expect(page.getByRole("region", { name: "Sections to start from" })).toHaveCount(0);
  // Bodies are heavier than the masses that stood for them: balanced anew, as good as before.
  await expect(figure(page, "Couple, order 1")).not.toHaveText(points ?? "");
  await page.getByRole("button", { name: "To the tab Balance" }).click();
  await balance(await figure(page, "Couple, order 1").textContent());
  await expect(figure(page, "Couple, order 1")).toHaveText(points ?? "");
  await page.getByRole("tab", { name: "Counterweight" }).click();
  await page.getByRole("button", { name: "Find the best shape" }).click();
  const best = page.getByRole("region", { name: "Best shape" });
  await expect(best).toContainText("the least mass is");
  await best.getByRole("button", { name: "Adopt" }).click();
  await expect(page.locator("path.part")).toBeVisible();
  await expect(page.getByRole("table", { name: "Clearances" })).toContainText("kept");
  await expect(page.getByRole("region", { name: "Sections to start from" })).toHaveCount(0);
  await page.evaluate(() => scrollTo(0, 0));
  await page.screenshot({ path: info.outputPath("outlines.png") });

  await page.getByRole("tab", { name: "Engine" }).click();
  await page.keyboard.press("Control+s");
  await page.getByRole("dialog", { name: "Save as" }).getByLabel("Name of the file").fill("balanced");
  await page.keyboard.press("Enter");
  await expect(page.getByText("Saved balanced.toml")).toBeVisible();
  const saved = await studio.read("balanced.toml");
  expect(saved).toContain("[[counterweight]]");
  expect(saved).toContain("shape = ");

  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Report" }).click();
  const report = info.outputPath("balanced.html");
  await (await waiting).saveAs(report);
  expect(await readFile(report, "utf8")).toContain("The crankshaft");
  console.log(`from the gallery to the report in ${((Date.now() - start) / 1000).toFixed(1)} s`);
});

test("the way to outlines goes by keyboard alone", async ({ studio, page }) => {
  await page.goto(studio.address);
  await opened(page);
  /** Tab by tab to a control, as without a mouse. */
  const reach = async (name: RegExp) => {
    const wanted = () =>
      page.evaluate((source) => {
        const at = document.activeElement;
        const said = at?.getAttribute("aria-label") ?? at?.textContent ?? "";
        return at !== document.body && new RegExp(source).test(said.trim());
      }, name.source);
    for (let steps = 0; steps < 80 && !(await wanted()); steps += 1) await page.keyboard.press("Tab");
    expect(await wanted(), `${name} by Tab`).toBe(true);
  };
  const tab = async (name: string, steps: number) => {
    await page.locator("[role=tab][aria-selected=true]").focus();
    for (let step = 0; step < steps; step += 1) await page.keyboard.press("ArrowRight");
    await expect(page.getByRole("tab", { name })).toBeFocused();
  };
  await reach(/^New$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("dialog", { name: "New engine" })).toBeVisible();
  await reach(/in-line three$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("heading", { level: 1 })).toContainText("in-line 3");
  await tab("Balance", 2);
  await reach(/^Optimise$/);
  await page.keyboard.press("Enter");
  const answer = page.getByRole("region", { name: "Optimise" });
  await expect(answer.getByRole("heading", { name: "Optimum found and proved" })).toBeVisible();
  await page.keyboard.press("Tab");
  await reach(/^Adopt$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("tabpanel")).toBeFocused();
  await tab("Counterweight", 1);
  await reach(/^Add all to start from$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("region", { name: "Sections to start from" })).toHaveCount(0);
  await expect(page.getByRole("tabpanel")).toBeFocused();
  await reach(/^Find the best shape$/);
  await page.keyboard.press("Enter");
  const best = page.getByRole("region", { name: "Best shape" });
  await expect(best).toContainText("the least mass is");
  await reach(/^Adopt$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("button", { name: /^web 1/ })).toContainText(/\d g/);
  await page.keyboard.press("Control+s");
  await expect(page.getByLabel("Name of the file")).toBeFocused();
  await page.keyboard.press("Control+a");
  await page.keyboard.type("by-keyboard");
  await page.keyboard.press("Enter");
  await expect(page.getByText("Saved by-keyboard.toml")).toBeVisible();
});
