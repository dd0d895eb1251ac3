// The Counterweight tab: from a template to outlines, handles, best shape, front, export.

import { readFileSync } from "node:fs";
import type { Page } from "@playwright/test";
import { newEngine, text as fileText } from "./page";
import { points } from "./points";
import { expect, test } from "./server";

test.use({ example: "in-line-3-counterweights.toml" });

async function open(page: Page, address: string) {
  await page.goto(address);
  await page.getByRole("tab", { name: "Counterweight" }).click();
}

/** The file's text, read on the tab Engine. */
async function text(page: Page): Promise<string> {
  await page.getByRole("tab", { name: "Engine" }).click();
  await expect(page.locator(".cm-content")).toBeVisible();
  const found = await fileText(page);
  await page.getByRole("tab", { name: "Counterweight" }).click();
  return found;
}

const outline = (page: Page) => page.locator("path.part");
const mass = (page: Page) => page.locator("[data-fact=mass]");
const field = (page: Page, name: string) => page.getByRole("textbox", { name });

/** Finds the best shapes and takes them. */
async function adoptBest(page: Page) {
  await page.getByRole("button", { name: "Find the best shape" }).click();
  const best = page.getByRole("region", { name: "Best shape" });
  await expect(best).toContainText("Proved: no shape within the ranges goes below");
  await best.getByRole("button", { name: "Adopt" }).click();
  // The digits that count; the file has all of them.
  await expect(field(page, "Arc radius")).toHaveValue("94.42 mm");
  await expect(field(page, "Arc radius")).toHaveAttribute("title", /^94\.4198\d* mm$/);
  await expect(mass(page)).toHaveText(/^160\d/);
}

test("the best shape is found with its proof, adopted and undone", async ({ studio, page }) => {
  await open(page, studio.address);
  await expect(outline(page)).toBeVisible();
  await expect(page.getByRole("button", { name: /^web 1/ })).toContainText("no shape yet");
  await page.getByRole("button", { name: "Find the best shape" }).click();
  const best = page.getByRole("region", { name: "Best shape" });
  await expect(best).toContainText("1603.8 g");
  await expect(best).toContainText("piston 1 is in the way");
  await expect(page.locator("path.ghost")).toBeVisible();
  await best.getByRole("button", { name: "Adopt" }).click();
  await expect(page.getByRole("button", { name: /^web 1/ })).toContainText(/16\d\d g/);
  await expect(page.locator("path.ghost")).toHaveCount(0);
  await expect(page.getByRole("table", { name: "Clearances" })).toContainText("piston 1");
  await page.locator("body").press("Control+z");
  await expect(page.getByRole("button", { name: /^web 1/ })).toContainText("no shape yet");
});

test("a handle that is dragged changes outline, mass and file, as one step", async ({ studio, page }) => {
  await open(page, studio.address);
  await adoptBest(page);
  const [before, grams] = [await outline(page).getAttribute("d"), await mass(page).innerText()];
  const handle = page.getByRole("slider", { name: "Arc radius" });
  await handle.scrollIntoViewIfNeeded();
  const box = (await handle.boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y + 24, { steps: 6 });
  await page.mouse.up();
  await expect(outline(page)).not.toHaveAttribute("d", before!);
  await expect(mass(page)).not.toHaveText(grams);
  await expect(field(page, "Arc radius")).not.toHaveValue(/^94/);
  expect(parseFloat(await field(page, "Arc radius").inputValue())).toBeLessThan(92);
  await expect(page.getByLabel("The part")).toContainText("too light");
  await page.locator("body").press("Control+z");
  await expect(field(page, "Arc radius")).toHaveValue(/^94/);
  await expect(mass(page)).toHaveText(grams);
});

test("a handle follows the keyboard, and tells what comes too close", async ({ studio, page }) => {
  await open(page, studio.address);
  await adoptBest(page);
  const handle = page.getByRole("slider", { name: "Arc radius" });
  await handle.focus();
  await handle.press("PageUp");
  await expect(handle).toHaveAttribute("aria-valuetext", "99.42 mm");
  const row = page.getByRole("table", { name: "Clearances" }).getByRole("row", { name: /^piston 1/ });
  await expect(row).toContainText(/too close|touches/);
  await expect(page.getByRole("button", { name: /^web 1/ })).toContainText("too close");
});

test("a dimension is typed in any unit; a wrong one shows its message", async ({ studio, page }) => {
  await open(page, studio.address);
  await adoptBest(page);
  const grams = await mass(page).innerText();
  await field(page, "Arc radius").fill("3.5 in");
  await field(page, "Arc radius").press("Enter");
  await expect(page.getByRole("slider", { name: "Arc radius" })).toHaveAttribute(
    "aria-valuetext",
    "88.90 mm",
  );
  await expect(mass(page)).not.toHaveText(grams);
  await field(page, "Thickness").fill("26 kg");
  await field(page, "Thickness").press("Enter");
  const dimensions = page.getByRole("region", { name: "Dimensions" });
  await expect(dimensions.getByRole("alert")).toHaveText(/length/);
  await expect(field(page, "Thickness")).toHaveAttribute("aria-invalid", "true");
});

test("a point of the front is drawn over the present outline and adopted", async ({ studio, page }) => {
  await open(page, studio.address);
  await adoptBest(page);
  await page.getByRole("button", { name: "Trace the front" }).click();
  const front = page.getByRole("region", { name: "Front of designs" });
  await expect(front).toContainText("Proved: below the line there is nothing.");
  const all = await points(front);
  expect(all.length).toBeGreaterThan(10);
  await page.mouse.click(...all[2]!);
  await expect(front).toContainText(/Design \d+:/);
  const ghost = page.locator("path.ghost");
  await expect(ghost).toHaveAttribute("d", /^M/);
  const drawn = await ghost.getAttribute("d");
  expect(drawn).not.toBe(await outline(page).getAttribute("d"));
  await front.getByRole("button", { name: /^Adopt for/ }).click();
  await expect(ghost).toHaveCount(0);
  await expect(field(page, "Arc radius")).not.toHaveValue(/^92\.4999/);
});

test("a drawing gives a weight its outline, and the same drawing comes back", async ({ studio, page }) => {
  await open(page, studio.address);
  await adoptBest(page);
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Export web 1 as DXF" }).click();
  const drawing = readFileSync(await (await waiting).path(), "utf8");
  const before = await text(page);
  const region = page.getByRole("region", { name: "Outline from a drawing" });
  const take = (name: string, what: string) =>
    region
      .getByLabel("Drawing for web 1")
      .setInputFiles({ name, mimeType: "image/vnd.dxf", buffer: Buffer.from(what) });
  // What is no drawing is refused, and changes nothing.
  await take("web.dxf", "no drawing at all");
  await expect(region.getByRole("alert")).toBeVisible();
  expect(await text(page)).toBe(before);
  await take("web 1.dxf", drawing);
  // The plate that was exported, with the disc of its web: `counterweight design` says 2984.0 g.
  await expect(region.getByRole("status")).toContainText(/web 1 has the outline of web 1\.dxf: 2.?984 g/);
  await expect(region.getByRole("alert")).toHaveCount(0);
  expect(await text(page)).not.toBe(before);
  await expect(outline(page)).toBeVisible();
  await page.locator("body").press("Control+z");
  expect(await text(page)).toBe(before);
});

test.describe("a template", () => {
  test.use({ example: "in-line-4-production.toml" });

  test("becomes outlines with clicks only", async ({ studio, page }) => {
    await open(page, studio.address);
    const setup = page.getByRole("region", { name: "Sections to start from" });
    await setup.getByRole("button", { name: "Add all to start from" }).click();
    await expect(setup).toHaveCount(0);
    await page.getByRole("button", { name: "Find the best shape" }).click();
    const best = page.getByRole("region", { name: "Best shape" });
    await expect(best).toContainText("the least mass is");
    await best.getByRole("button", { name: "Adopt" }).click();
    await expect(page.getByRole("button", { name: /^web 1/ })).toContainText(/\d g/);
  });
});

test.describe("an engine whose limits leave no shape", () => {
  test.use({ example: "" });

  test("is told the nearest limit, which is filled in with a click", async ({ studio, page }) => {
    await page.goto(studio.address);
    await newEngine(page, "boxer", "boxer twin");
    await page.getByRole("tab", { name: "Counterweight" }).click();
    await page.getByRole("button", { name: "Add all to start from" }).click();
    // Webs between the pins carry no weights: there is no room for them.
    await expect(page.getByRole("list", { name: "Counterweights" }).getByRole("button")).toHaveCount(2);
    await page.getByRole("button", { name: "Find the best shape" }).click();
    const best = page.getByRole("region", { name: "Best shape" });
    await expect(best).toContainText("no shape within the ranges has the unbalance that is wanted");
    const before = await text(page);
    await best.getByRole("button", { name: /^Set balance to 4\d\.\d %$/ }).click();
    await expect(best).toContainText("the least mass is");
    expect(before).not.toMatch(/^balance = /m);
    await best.getByRole("button", { name: "Adopt" }).click();
    await expect(outline(page)).toBeVisible();
    await page.locator("body").press("Control+z");
    await page.locator("body").press("Control+z");
    expect(await text(page)).toBe(before);
  });
});
