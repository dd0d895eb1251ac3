// Files for CAD as the page hands them out: they hold what the page says.

import type { Page } from "@playwright/test";
import { readFile } from "node:fs/promises";
import { dxf, glb, step, stl } from "./solids";
import { expect, test } from "./server";

test.use({ example: "in-line-3-counterweights.toml" });

/** Of the file's [crank.body] [kg/mm3]. */
const DENSITY = 7850e-9;
/** Facets stand off a true arc by 0.01 mm at most: of a web of some 50 mm that is less than this part of its volume. */
const FACETS = 5e-4;
const PIECES = ["journal 1", "web 1", "pin 1", "web 2", "journal 2"];

async function exported(page: Page, button: string): Promise<Buffer> {
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: button, exact: true }).click();
  const file = await download;
  const [part, format] = / (web 1|crankshaft) as (\w+)$/.exec(button)!.slice(1) as [string, string];
  expect(file.suggestedFilename()).toBe(
    `in-line-3-counterweights-${part.replace(" ", "-")}.${format.toLowerCase()}`,
  );
  return readFile(await file.path());
}

test.beforeEach(async ({ studio, page }) => {
  await page.goto(studio.address);
  await page.getByRole("tab", { name: "Counterweight" }).click();
  await expect(page.locator("path.part")).toBeVisible();
});

/** Gives the best shapes to all four weights. */
async function adopt(page: Page) {
  await page.getByRole("button", { name: "Find the best shape" }).click();
  await page.getByRole("region", { name: "Best shape" }).getByRole("button", { name: "Adopt" }).click();
  await expect(page.getByRole("button", { name: /^web 1/ })).toContainText(/\d g/);
}

/** The mass that is shown [kg]. */
async function mass(page: Page): Promise<number> {
  return parseFloat(await page.locator("[data-fact=mass]").innerText()) / 1e3;
}

test("the crankshaft's solids have the mass that is shown", async ({ page }) => {
  const bare = stl(await exported(page, "Export the crankshaft as STL"));
  await adopt(page);
  const whole = stl(await exported(page, "Export the crankshaft as STL"));
  // Four weights are alike, and what they add is what is shown of one.
  const added = ((whole.volume - bare.volume) * DENSITY) / 4;
  // Facets take two thirds of 0.01 mm off 240 mm of arc, 26 mm thick: 0.3 g.
  expect(Math.abs(added - (await mass(page)))).toBeLessThan(1e-3);
  expect(whole.triangles).toBeGreaterThan(1000);

  const { solids, unit } = step(await exported(page, "Export the crankshaft as STEP"));
  // Four journals, three pins, six webs, each with its weight.
  expect(solids).toBe(13);
  expect(unit).toBe(".MILLI.");
  const { bodies } = glb(await exported(page, "Export the crankshaft as GLB"));
  expect(bodies).toHaveLength(13);
  PIECES.forEach((piece, at) => expect(bodies[at]).toMatch(new RegExp(`^${piece}`)));
});

test("a weight is the same in every format", async ({ page }) => {
  await adopt(page);
  const thickness = parseFloat(await page.getByRole("textbox", { name: "Thickness" }).inputValue());
  const solid = stl(await exported(page, "Export web 1 as STL"));
  const outline = dxf(await exported(page, "Export web 1 as DXF"));
  expect(outline.contours).toBe(1);
  expect(Math.abs(solid.volume / (outline.area * thickness) - 1)).toBeLessThan(FACETS);
  expect(solid.most[2] - solid.least[2]).toBeCloseTo(thickness, 4);
  // The file holds the disc of the web too: the weight is lighter.
  expect(solid.volume * DENSITY).toBeGreaterThan(await mass(page));
  await expect(page.getByRole("region", { name: "Export" })).toContainText("the disc of its web too");

  expect(step(await exported(page, "Export web 1 as STEP"))).toEqual({ solids: 1, unit: ".MILLI." });
  expect(glb(await exported(page, "Export web 1 as GLB")).bodies).toEqual(["web 1"]);

  const svg = (await exported(page, "Export web 1 as SVG")).toString("utf8");
  const drawn = await page.evaluate((text) => {
    const document_ = new DOMParser().parseFromString(text, "image/svg+xml");
    const path = document_.querySelector("path");
    if (document_.querySelector("parsererror") || !path) return undefined;
    const copy = document.importNode(path, true);
    const holder = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    holder.append(copy);
    document.body.append(holder);
    const [length, count] = [copy.getTotalLength(), 4000];
    const at = (index: number) => copy.getPointAtLength((length * (index % count)) / count);
    let area = 0;
    for (let index = 0; index < count; index += 1) {
      const [a, b] = [at(index), at(index + 1)];
      area += (a.x * b.y - b.x * a.y) / 2;
    }
    holder.remove();
    return { area: Math.abs(area), width: document_.documentElement.getAttribute("width") };
  }, svg);
  expect(drawn?.width).toMatch(/^[\d.]+mm$/);
  expect(drawn!.area / outline.area).toBeCloseTo(1, 3);
});
