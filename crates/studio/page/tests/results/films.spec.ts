// Oil films on the Results tab: the film of a bearing unrolled, and least films over speed, computed on request.

import type { Locator, Page } from "@playwright/test";
import { readFile } from "node:fs/promises";
import type { BearingFilms } from "../../src/api/types";
import { expect, test, type Studio } from "../server";

test.use({ example: "in-line-4-crank-by-elements.toml" });

async function open(page: Page, studio: Studio) {
  await page.goto(studio.address);
  await page.getByRole("tab", { name: "Results" }).click();
  await page
    .getByRole("navigation", { name: "Kinds of results" })
    .getByRole("button", { name: "Oil films" })
    .click();
  await expect(map(page)).toBeVisible();
}

const plot = (page: Page, title: string) => page.locator(`figure[data-plot="${title}"]`);
const map = (page: Page) => page.locator('figure[data-plot^="Film of"]');
const section = (page: Page) => page.getByRole("region", { name: "Films over speed" });

/** Least film and its crank angle in the table, as they are written. */
async function row(page: Page, bearing: string): Promise<string[]> {
  const cells = page
    .getByRole("region", { name: "Films over the cycle" })
    .getByRole("row", { name: new RegExp(`^${bearing} `) })
    .getByRole("cell");
  return (await cells.allTextContents()).slice(0, 2);
}

/** Name and place of the mark in the map, as shares of its ground. */
async function mark(figure: Locator): Promise<{ name: string; x: number; y: number }> {
  const circle = figure.locator("circle.marker");
  const [name, at] = await Promise.all([circle.locator("title").textContent(), circle.boundingBox()]);
  const ground = await figure.getByRole("slider").boundingBox();
  if (!name || !at || !ground) throw new Error("nothing is marked");
  return {
    name,
    x: (at.x + at.width / 2 - ground.x) / ground.width,
    y: 1 - (at.y + at.height / 2 - ground.y) / ground.height,
  };
}

test("the film of each bearing is unrolled, with its least film where the table has it", async ({
  page,
  studio,
}) => {
  const mistakes: string[] = [];
  page.on("pageerror", (error) => mistakes.push(error.message));
  await open(page, studio);
  const choice = page.getByRole("combobox", { name: "Bearing", exact: true });
  // At first the bearing with the thinnest film.
  await expect(choice).toHaveValue("main 3");
  for (const bearing of ["main 3", "main 1", "big end 2"]) {
    await choice.selectOption(bearing);
    const [least, at] = await row(page, bearing);
    const own = page.getByRole("region", { name: "Film of one bearing unrolled" });
    await expect(own.getByRole("status")).toContainText(
      `Thinnest film of ${bearing}: ${least} µm at crank angle ${at}`,
    );
    const found = await mark(map(page));
    expect(found.name).toBe(`${least} µm`);
    expect(found.x).toBeCloseTo(Number(at!.replace("°", "")) / 720, 2);
    // The readout at that crank angle finds the same thickness at the height of the mark.
    const surface = map(page).getByRole("slider");
    await surface.evaluate((element) => element.scrollIntoView({ block: "center" }));
    const box = (await surface.boundingBox())!;
    await page.mouse.move(box.x + found.x * box.width, box.y + (1 - found.y) * box.height);
    await expect(surface).toHaveAttribute("aria-valuetext", new RegExp(`thinnest ${least} µm at `));
    const words = (await surface.getAttribute("aria-valuetext")) ?? "";
    const angle = Number(/thinnest .* at ([\d.]+)°/.exec(words)?.[1]);
    expect(angle / 360).toBeCloseTo(found.y, 2);
    for (const d of await map(page)
      .locator("path.region")
      .evaluateAll((paths) => paths.map((path) => path.getAttribute("d") ?? "")))
      expect(d).not.toMatch(/NaN|Infinity|undefined/);
  }
  expect(mistakes).toEqual([]);
});

test("the map follows the keys, and is saved with its scale and as numbers", async ({ page, studio }) => {
  await open(page, studio);
  const surface = map(page).getByRole("slider");
  await surface.focus();
  await page.keyboard.press("ArrowRight");
  await expect(surface).toHaveAttribute("aria-valuetext", /^Crank angle 1\.0°: thinnest [\d.]+ µm at /);
  const saved = async (format: string) => {
    const download = page.waitForEvent("download");
    await map(page)
      .getByRole("button", { name: `(${format})` })
      .click();
    const own = await download;
    return { name: own.suggestedFilename(), text: await readFile(await own.path(), "utf8") };
  };
  const csv = await saved("CSV");
  expect(csv.name).toBe("film-main-3-unrolled.csv");
  const lines = csv.text.trim().split("\r\n");
  expect(lines[0]).toContain("Crank angle [°],0° in the shell [µm],10° in the shell [µm]");
  const numbers = lines.slice(1).map((line) => line.split(",").map(Number));
  expect(numbers).toHaveLength(720);
  const [least] = await row(page, "main 3");
  const thinnest = Math.min(...numbers.flatMap((line) => line.slice(1)));
  // Between two columns of ten degrees it may be thinner.
  expect(thinnest).toBeGreaterThanOrEqual(Number(least) * 0.99);
  expect(thinnest).toBeLessThan(Number(least) + 0.2);
  const svg = await saved("SVG");
  expect(svg.text).toContain("0 to 0.75 µm");
  expect(svg.text).not.toMatch(/NaN|var\(--/);
});

test("films with the grooves of the file are solved on request", async ({ page, studio }) => {
  // Some seconds a bearing, on a busy machine too.
  test.setTimeout(180_000);
  await open(page, studio);
  const plain = await row(page, "main 3");
  await expect(page.getByRole("region", { name: "Films over the cycle" })).toContainText(
    "grooves and supply pressure are left out",
  );
  await page.getByRole("button", { name: "With the grooves of the file" }).click();
  await expect(page.getByText("Solving films with grooves")).toBeVisible();
  await page.getByRole("button", { name: "Stop" }).first().click();
  await expect(page.getByText("Grooves are left out; with them")).toBeVisible();
  expect(await row(page, "main 3")).toEqual(plain);

  await page.getByRole("button", { name: "With the grooves of the file" }).click();
  await expect(page.getByText("Films with the grooves of the file.")).toBeVisible({ timeout: 150_000 });
  const grooved = await row(page, "main 3");
  // A groove takes from the film.
  expect(Number(grooved[0])).toBeLessThan(Number(plain[0]));
  await expect(page.getByRole("region", { name: "Films over the cycle" })).toContainText(
    "grooves are fed with",
  );
  await expect(page.getByRole("region", { name: "Film of one bearing unrolled" })).toContainText(
    "deformation of the shell, oil holes",
  );
  await page.getByRole("button", { name: "Without grooves" }).click();
  expect(await row(page, "main 3")).toEqual(plain);
});

test("films over speed run in the background, are stopped, and become out of date", async ({
  page,
  studio,
}) => {
  // Fifteen speeds of nine films, on a busy machine too.
  test.setTimeout(150_000);
  await open(page, studio);
  const start = page.getByRole("button", { name: "Least film over speed" });
  const stop = section(page).getByRole("button", { name: "Stop" });
  await expect(plot(page, "Least film of the main bearings over speed")).toBeHidden();

  await start.click();
  await expect(section(page)).toContainText(/[1-9]\d* of 15/);
  await stop.click();
  await expect(section(page).getByRole("status")).toContainText(/Stopped after \d+ of 15 speeds\./);
  await expect(start).toBeEnabled();

  // It goes on while something else is looked at.
  await start.click();
  await page.getByRole("tab", { name: "Engine" }).click();
  await page.getByRole("tab", { name: "Results" }).click();
  const status = section(page).getByRole("status");
  await expect(status).toContainText(/Thinnest of all: [\d.]+ µm, .+ at \d+ rpm\./, { timeout: 100_000 });
  await expect(section(page)).not.toContainText("Out of date");

  // At the highest speed, where the page stands, the curves have the numbers of the table.
  for (const [bearing, title] of [
    ["main 3", "Least film of the main bearings over speed"],
    ["big end 1", "Least film of the big ends over speed"],
  ] as const) {
    const [least] = await row(page, bearing);
    const figure = plot(page, title);
    await figure.scrollIntoViewIfNeeded();
    await expect(figure.locator(".reading")).toContainText("6500 rpm");
    const value = await figure.getByRole("button", { name: bearing }).locator(".number").textContent();
    expect(Number(value!.replace(" µm", ""))).toBeCloseTo(Number(least), 2);
    await expect(figure.locator("circle.marker")).toHaveCount(1);
    await expect(figure).toContainText("speed of the page");
  }
  await expect(plot(page, "Friction of the films over speed")).toBeVisible();

  await page.getByText("No cavitation", { exact: true }).click();
  await expect(section(page)).toContainText("Out of date");
  await page.getByText("As the file says", { exact: true }).click();
  await expect(section(page)).not.toContainText("Out of date");
});

test("an overloaded film is said and not drawn", { tag: "@server" }, async ({ page, studio }) => {
  await page.route("**/api/films", async (route) => {
    const response = await route.fetch();
    const answer = (await response.json()) as BearingFilms;
    const slow = answer.speed < (1300 * Math.PI) / 30;
    if (slow || (route.request().postDataJSON() as { speed?: number }).speed === undefined)
      answer.films[1]!.orbit.outcome = "overloaded";
    await route.fulfill({ response, json: answer });
  });
  await open(page, studio);
  await page.getByRole("combobox", { name: "Bearing", exact: true }).selectOption("main 2");
  await expect(page.getByText("Main 2 is overloaded: the film does not carry this load.")).toBeVisible();
  await expect(map(page)).toBeHidden();
  await page.getByRole("combobox", { name: "Bearing", exact: true }).selectOption("main 1");
  await expect(map(page)).toBeVisible();

  await page.getByRole("button", { name: "Least film over speed" }).click();
  await expect(section(page)).toContainText("the film does not carry the load: main 2 at 800, 1200 rpm.");
  await section(page).getByRole("button", { name: "Stop" }).click();
  // The answer that was stopped is not waited for.
  await page.unrouteAll({ behavior: "ignoreErrors" });
});
