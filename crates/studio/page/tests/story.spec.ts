// Stories of the guide's page "Five users, five stories", and the main one: from the gallery to a saved file and its report.

import { execFile } from "node:child_process";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { promisify } from "node:util";
import { field, figure, newEngine, opened, text, type } from "./page";
import { expect, PROGRAM, test } from "./server";

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

test("an NVH engineer finds what reaches the frame, what matters most for it, and takes the curves along", async ({
  studio,
  page,
}) => {
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "flat crank", "in-line four, flat crank");
  await page.getByRole("tab", { name: "Results" }).click();
  const kinds = page.getByRole("navigation", { name: "Kinds of results" });
  await kinds.getByRole("button", { name: "Mounts" }).click();
  await page.getByRole("button", { name: "Insert typical values" }).click();
  const forces = page.locator('figure[data-plot^="Force on the mount"]').first();
  await expect(forces).toBeVisible();
  const waiting = page.waitForEvent("download");
  await forces.getByRole("button", { name: "(CSV)" }).click();
  const lines = (await readFile(await (await waiting).path(), "utf8")).trim().split("\r\n");
  expect(lines[0]).toContain("Speed [rpm]");
  expect(lines.length).toBeGreaterThan(50);

  await kinds.getByRole("button", { name: "What matters most" }).click();
  await page.getByRole("radio", { name: "Mounts" }).check({ force: true });
  const most = page.getByRole("region", { name: /mount force/ });
  await expect(most.getByRole("row").nth(1)).toContainText("%");
  await expect(most).toContainText("mount stiffness");
});

test("a student sees why a single shakes, what a counterweight can do, and what it costs", async ({
  studio,
  page,
}) => {
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "single", "single, four-stroke, crank counterweight of 50 %");
  await page.getByRole("tab", { name: "Results" }).click();
  await expect(page.getByRole("region", { name: "What shakes, and what removes it" })).toContainText("force");
  const before = Number((await figure(page, "Force, order 1").textContent())?.replace(/\D/g, ""));
  await page.getByRole("tab", { name: "Compare" }).click();
  await page.getByRole("button", { name: "Pin this state" }).click();
  await page.getByRole("tab", { name: "Engine" }).click();
  // Nothing against the reciprocating mass: the two halves of its first order turn both ways, and make twice as much where they meet.
  await page.getByRole("heading", { name: "Counterweights" }).click();
  await type(page, "counterweights.reciprocating_share", "0 %");
  const order = async () => Number((await figure(page, "Force, order 1").textContent())?.replace(/\D/g, ""));
  await expect.poll(order).toBeGreaterThan(1.9 * before);
  expect(await order()).toBeLessThan(2.1 * before);
  await page.getByRole("tab", { name: "Compare" }).click();
  await expect(page.getByRole("heading", { name: "Headline numbers" })).toBeVisible();
});

test(
  "a researcher has the published figures drawn from computed numbers",
  { tag: "@server" },
  async ({ studio, page }) => {
    await promisify(execFile)(PROGRAM, ["validate", "Figure 18", "--figures", "atlas"], {
      cwd: studio.folder,
    });
    await page.goto(pathToFileURL(join(studio.folder, "atlas", "index.html")).href);
    const picture = page.getByRole("img").first();
    await expect(picture).toBeVisible();
    expect(await picture.evaluate((image) => image.getBoundingClientRect().width)).toBeGreaterThan(200);
    const values = await readFile(join(studio.folder, "atlas", "twin-thesis-figure-18.csv"), "utf8");
    expect(values.split("\n").length).toBeGreaterThan(300);
  },
);
