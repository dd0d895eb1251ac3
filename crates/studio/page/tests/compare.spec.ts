// The Compare tab: pinned states beside the current one.

import { readFile } from "node:fs/promises";
import { resolve } from "node:path";
import type { Page } from "@playwright/test";
import { deflateRawSync } from "node:zlib";
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
  await expect(page.getByText(/Pin the state you have/)).toBeVisible();
  await page.getByRole("button", { name: "Pin this state" }).click();
  await expect(page.getByRole("textbox", { name: /Name of the pinned state/ })).toHaveCount(1);
  await expect(page.getByRole("heading", { name: "Headline numbers" })).toBeVisible();
  await expect(page.getByText(/Pin the state you have/)).toHaveCount(0);
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
