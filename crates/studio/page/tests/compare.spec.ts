// The tabs Compare and Studies: pinned states beside the current one, and studies of many engines.

import { readFile, writeFile } from "node:fs/promises";
import { resolve } from "node:path";
import type { Page } from "@playwright/test";
import { deflateRawSync } from "node:zlib";
import { opened } from "./page";
import { expect, test, type Studio } from "./server";

const EXAMPLES = resolve("../../../examples");

/** The studio with a current state and pins, as a link holds them. */
async function open(page: Page, studio: Studio, current: string, pins: string[]) {
  const read = (name: string) => readFile(resolve(EXAMPLES, name), "utf8");
  const state = {
    version: 1,
    name: current,
    text: await read(current),
    tab: "compare",
    theta: 0,
    speed: null,
    units: "SI",
    pins: await Promise.all(
      pins.map(async (name, index) => ({
        name: name.replace(".toml", ""),
        text: await read(name),
        colour: index + 2,
      })),
    ),
  };
  const word = deflateRawSync(JSON.stringify(state)).toString("base64url");
  await page.goto(`${studio.address}#state=${word}`);
}

const figures = (page: Page, title: string) => page.locator(`figure[data-plot="${title}"]`);

test("without pins the tab says what it is for, and a state is pinned", async ({ page, studio }) => {
  await page.goto(studio.address);
  await page.getByRole("tab", { name: "Compare" }).click();
  await expect(page.getByText(/pin the state you have/)).toBeVisible();
  await page.getByRole("button", { name: "Pin this state" }).click();
  await expect(page.getByRole("textbox", { name: /Name of the pinned state/ })).toHaveCount(1);
  await expect(page.getByRole("heading", { name: "Headline numbers" })).toBeVisible();
  await expect(page.getByText(/pin the state you have/)).toHaveCount(0);
});

test("states are overlaid in curves, paths, spectra and numbers", async ({ page, studio }) => {
  await open(page, studio, "in-line-3.toml", ["in-line-4.toml", "twin-in-line-in-phase.toml"]);
  // What is far out of sight is drawn when it comes near.
  for (const title of ["Vertical force (x)", "Pitch couple (about y)", "Hodographs of the force"]) {
    await figures(page, title).scrollIntoViewIfNeeded();
    await expect(figures(page, title).locator("path.line[style*='--colour']"), title).toHaveCount(3);
  }
  await figures(page, "Order spectra of the force").scrollIntoViewIfNeeded();
  await expect(figures(page, "Order spectra of the force").locator("path.bars")).toHaveCount(3);

  const numbers = page.getByRole("region", { name: "Headline numbers" });
  await expect(numbers.getByRole("columnheader")).toHaveCount(4);
  // The reference has no differences; chosen anew, the others have them.
  const row = numbers.getByRole("row", { name: /Peak force/ });
  const before = await row.getByRole("cell").allTextContents();
  await page.getByLabel("Compared with").selectOption({ label: "Current state" });
  await expect.poll(() => row.getByRole("cell").allTextContents()).not.toEqual(before);
});

test("engines are ranked in words, as they are and at equal displacement", async ({ page, studio }) => {
  await open(page, studio, "in-line-4-mounts.toml", ["single-gas.toml"]);
  const panel = page.getByRole("region", { name: "Ranking" });
  await expect(panel.getByText(/\(.*\), then .*\./).first()).toBeVisible();
  const displacement = panel.getByRole("row", { name: /Displacement/ });
  const own = await displacement.getByRole("cell").allTextContents();
  expect(own[0]).not.toBe(own[1]);
  await panel.getByText("Equal displacement").click();
  await expect
    .poll(async () => {
      const both = await displacement.getByRole("cell").allTextContents();
      return both[0] === both[1];
    })
    .toBe(true);
});

test("pins are renamed, opened as the current state, and removed", async ({ page, studio }) => {
  await open(page, studio, "in-line-3.toml", ["in-line-4.toml"]);
  const name = page.getByRole("textbox", { name: /Name of the pinned state/ });
  await name.fill("four in line");
  await name.press("Enter");
  await expect(page.getByRole("columnheader", { name: /four in line/ }).first()).toBeVisible();
  await page.getByRole("button", { name: "Pin this state" }).click();
  await expect(name).toHaveCount(2);

  await page.getByRole("button", { name: "Open as current" }).first().click();
  await expect(page.getByText("same as “four in line”")).toBeVisible();
  await page.keyboard.press("Control+z");
  await expect(page.getByText("same as “four in line”")).toHaveCount(0);

  await page.getByRole("button", { name: /^Remove four in line/ }).click();
  await expect(name).toHaveCount(1);
});

test.describe("studies", () => {
  test.use({ example: "in-line-4.toml" });

  async function study(page: Page, studio: Studio, name: string) {
    await page.goto(studio.address);
    await opened(page);
    await page.getByRole("tab", { name: "Studies" }).click();
    await page.getByRole("navigation", { name: "Studies" }).getByRole("button", { name }).click();
  }

  test("layouts are searched, sorted, pinned and used", async ({ page, studio }) => {
    await study(page, studio, "Explore layouts");
    await expect(page.getByText("13\u202f824 cases")).toBeVisible();
    await page.getByRole("button", { name: "Search", exact: true }).click();
    const table = page.getByRole("table", { name: "Pareto-optimal layouts" });
    const first = table.getByRole("row").nth(1);
    await expect(first).toContainText("0 180 180 0");
    await expect(first).toContainText("1-3-4-2");
    await expect(figures(page, "Layouts by two objectives").locator("path.points")).toHaveCount(2);

    // Sorted by the force of second order: the first then has none of it.
    await table.getByRole("button", { name: /^force of order 2/ }).click();
    await expect(table.getByRole("columnheader", { name: /^force of order 2/ })).toHaveAttribute(
      "aria-sort",
      "ascending",
    );
    await expect(first).toContainText("0 180 90 270");

    await first.getByRole("button", { name: "Layout 5" }).click();
    const chosen = page.getByRole("region", { name: "Chosen layout" });
    await chosen.getByRole("button", { name: "Pin to Compare" }).click();
    await expect(chosen.getByText("Pinned to Compare as “layout 5”.")).toBeVisible();
    await chosen.getByRole("button", { name: "Use this layout" }).click();
    const force = page
      .getByRole("region", { name: "Loads in short" })
      .locator(".tile", { hasText: "Force, order 2" });
    await expect(force.locator("strong")).toHaveText("0");
    await expect(page.getByText(/The engine has changed since this search/)).toBeVisible();
    await expect(chosen.getByRole("button", { name: "Use this layout" })).toBeDisabled();

    await page.getByRole("tab", { name: "Compare" }).click();
    await expect(page.getByRole("textbox", { name: "Name of the pinned state layout 5" })).toBeVisible();
    await page.getByRole("button", { name: "Undo: use layout 5" }).click();
    await expect(force.locator("strong")).not.toHaveText("0");
  });

  test("a long search tells how far it is, and stops", async ({ page, studio }) => {
    await study(page, studio, "Explore layouts");
    await page.getByRole("combobox", { name: "Throws stand at" }).selectOption({ label: "every 10°" });
    await page.getByRole("spinbutton", { name: "Cylinders" }).fill("6");
    await expect(page.getByText(/^1\u202f934\u202f917\u202f632 cases/)).toBeVisible();
    await page.getByRole("button", { name: "Search", exact: true }).click();
    await expect(page.getByText(/about .* left/)).toBeVisible();
    await page.getByRole("button", { name: "Stop" }).click();
    await expect(page.getByRole("button", { name: "Search", exact: true })).toBeEnabled();
    await expect(page.getByRole("table", { name: "Pareto-optimal layouts" })).toHaveCount(0);
  });

  test("a production without tolerances gets typical ones, and is drawn by its seed", async ({
    page,
    studio,
  }) => {
    await study(page, studio, "Production scatter");
    await page.getByRole("button", { name: "Insert typical values" }).click();
    await page.getByRole("spinbutton", { name: "Engines" }).fill("20000");
    await page.getByRole("textbox", { name: /Limits/ }).fill("force order 1 = 1 N");
    const draw = page.getByRole("button", { name: "Draw", exact: true });
    await draw.click();
    const loads = page.getByRole("table", { name: "Loads of the production" });
    await expect(page.getByText(/20\u202f000 engines at .* seed 1,/)).toBeVisible();
    await expect(page.getByText("Limit not kept")).toBeVisible();
    await expect(figures(page, "Force of order 1").locator("path.area")).toHaveCount(1);
    const one = await loads.textContent();
    await page.getByRole("spinbutton", { name: "Seed" }).fill("2");
    await draw.click();
    await expect(page.getByText(/seed 2,/)).toBeVisible();
    expect(await loads.textContent()).not.toBe(one);
    await page.getByRole("spinbutton", { name: "Seed" }).fill("1");
    await draw.click();
    await expect(page.getByText(/seed 1,/)).toBeVisible();
    expect(await loads.textContent()).toBe(one);
  });

  test("published methods stand beside the optimum, and one that does not suit says why", async ({
    page,
    studio,
  }) => {
    await study(page, studio, "Published methods");
    const table = page.getByRole("table", { name: "Published methods" });
    await expect(table.getByRole("row", { name: /^Arrangement/ })).toHaveCount(9);
    const cells = table.getByRole("row", { name: /^Matrix method/ }).getByRole("cell");
    const [method, optimum] = (await cells.allTextContents()).map(Number);
    expect(optimum).toBeGreaterThan(0);
    expect(method).toBeGreaterThan(1.5 * (optimum ?? NaN));
    await expect(table.getByRole("row", { name: /^Sweep/ })).toContainText("Not for this engine");
  });

  test("weighed parts give bobweights, and the sheet is saved", async ({ page, studio }) => {
    await study(page, studio, "Workshop");
    await page.getByRole("textbox", { name: "Big end of the rod" }).fill("370");
    await page.getByRole("textbox", { name: "Small end of the rod" }).fill("180");
    await page.getByRole("textbox", { name: "Piston", exact: true }).fill("heavy");
    await expect(page.getByRole("alert")).toContainText("the workshop sheet has mistakes", {
      ignoreCase: true,
    });
    await page.getByRole("textbox", { name: "Piston", exact: true }).fill("430");
    await page.getByRole("textbox", { name: "Share [%]" }).fill("50");
    // 370 g turn with the pin, and half of 610 g.
    await expect(page.getByRole("region", { name: "Bobweights" })).toContainText("675.00 g");
    await expect(page.getByRole("region", { name: "lanchester workshop bobweight" })).toContainText("675.0");
    const waiting = page.waitForEvent("download");
    await page.getByRole("button", { name: "Save the sheet" }).click();
    const sheet = await readFile(await (await waiting).path(), "utf8");
    expect(sheet).toContain('piston = "430 g"');

    await page.getByText("Measured on the balancing machine").click();
    await page.getByRole("combobox", { name: /Grade/ }).selectOption("G 6.3");
    await page.getByRole("textbox", { name: "Mass of the crank" }).fill("24");
    await page.getByRole("textbox", { name: "Service speed" }).fill("5500");
    const fill = async (names: readonly string[], values: readonly string[]) => {
      for (const [place, name] of names.entries())
        await page.getByRole("textbox", { name, exact: true }).fill(values[place] ?? "");
    };
    await fill(["z at bearing 1", "unbalance at bearing 1", "angle at bearing 1"], ["0", "820", "171"]);
    await fill(["z at bearing 2", "unbalance at bearing 2", "angle at bearing 2"], ["420", "640", "38"]);
    await fill(["z of plane 1", "radius of plane 1"], ["35", "82"]);
    await fill(["z of plane 2", "radius of plane 2"], ["465", "125"]);
    const corrections = page.getByRole("region", { name: "lanchester workshop correct" });
    await expect(corrections).toContainText("Corrections");
    await expect(corrections).toContainText("842.5");
  });
});

test("engines are added beside the current one, at one speed or one piston speed, with what they cost", async ({
  page,
  studio,
}, info) => {
  await page.goto(studio.address);
  await opened(page);
  await page.getByRole("tab", { name: "Compare" }).click();
  const add = page.getByRole("button", { name: "Add an engine …" });
  const dialog = page.getByRole("dialog", { name: "Add an engine to compare" });
  await add.click();
  await dialog.getByRole("searchbox").fill("Porsche");
  await dialog.getByRole("button", { name: "boxer six" }).click();
  await expect(dialog).toBeHidden();
  await add.click();
  const path = info.outputPath("mine.toml");
  await writeFile(
    path,
    'name = "mine"\n[layout]\ntype = "single"\n[crank]\nstroke = "80 mm"\n[piston]\nmass = "0.4 kg"\n[rod]\nlength = "140 mm"\n',
  );
  await dialog.getByLabel("Engine files from this computer").setInputFiles(path);
  const names = page.getByRole("textbox", { name: /^Name of the pinned state/ });
  await expect(names).toHaveCount(2);
  await expect(names.first()).toHaveValue("boxer six");
  await expect(names.last()).toHaveValue("mine");
  await page.getByRole("button", { name: "Remove mine" }).click();

  const ranking = page.getByRole("region", { name: "Ranking" });
  const row = async (name: RegExp) =>
    (await ranking.getByRole("row", { name }).locator("td").allInnerTexts()).map((cell) =>
      Number(cell.replaceAll(/[\s\u202f]/g, "")),
    );
  await expect(ranking.getByRole("row", { name: "What it costs" })).toBeVisible();
  await expect(ranking.getByRole("row", { name: /^Balance shafts/ })).toBeVisible();
  await ranking.getByText("at one speed").click();
  await ranking.getByRole("spinbutton", { name: "Speed of all engines" }).fill("3000");
  await expect.poll(() => row(/^Speed/)).toEqual([3000, 3000]);
  await ranking.getByText("at one mean piston speed").click();
  await ranking.getByRole("spinbutton", { name: "Mean piston speed of all engines" }).fill("12");
  await expect.poll(() => row(/^Mean piston speed/)).toEqual([12, 12]);
  expect(new Set(await row(/^Speed/)).size).toBe(2);
});
