// The Balance tab: devices, optimum with its proof, arrangements.

import type { Page } from "@playwright/test";
import { newEngine, opened } from "./page";
import { points } from "./points";
import { expect, test } from "./server";

test.use({ example: "in-line-3-counterweights.toml" });

/** Opens the tab, and waits until the residual is there. */
async function open(page: Page, address: string) {
  await page.goto(address);
  await page.getByRole("tab", { name: "Balance" }).click();
  await expect(page.locator("[data-peak=force] .big")).toHaveText(/\d/);
}

/** The file's text as the page has it: a typed field is part of it. */
const amount = (page: Page, name: string) => page.getByRole("textbox", { name: `Amount of ${name}` });
const card = (page: Page, name: string) => page.getByRole("article", { name });
const force = (page: Page) => page.locator("[data-peak=force] .big");

test("a slider moves the residual and the file, as one step of undo", async ({ studio, page }) => {
  await open(page, studio.address);
  const before = await force(page).innerText();
  await expect(amount(page, "web 1")).toHaveValue("88.76 kg mm");
  const slider = card(page, "Counterweight web 1").getByRole("slider", { name: "Amount" });
  const box = (await slider.boundingBox())!;
  await page.mouse.move(box.x + box.width * 0.44, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.2, box.y + box.height / 2, { steps: 8 });
  await page.mouse.up();
  await expect(amount(page, "web 1")).not.toHaveValue("88.76 kg mm");
  await expect(amount(page, "web 1")).toHaveValue(/^[\d.]+ kg mm$/);
  await expect(force(page)).not.toHaveText(before);
  await expect(page.locator("[data-peak=force]")).toContainText("was");
  await page.locator("body").press("Control+z");
  await expect(amount(page, "web 1")).toHaveValue("88.76 kg mm");
  await expect(force(page)).toHaveText(before);
});

test("a slider follows the keyboard, step by step", async ({ studio, page }) => {
  await open(page, studio.address);
  const slider = card(page, "Counterweight web 1").getByRole("slider", { name: "Direction" });
  await slider.focus();
  for (let i = 0; i < 10; i++) await slider.press("ArrowRight");
  await expect(page.getByRole("textbox", { name: "Direction of web 1" })).toHaveValue("155 deg");
  // Directions count from the throw, wherever that stands.
  const other = card(page, "Counterweight web 5").getByRole("slider", { name: "Direction" });
  await other.press("ArrowLeft");
  await expect(page.getByRole("textbox", { name: "Direction of web 5" })).toHaveValue("209.5 deg");
});

test("a wrong typed value shows its message beside the field", async ({ studio, page }) => {
  await open(page, studio.address);
  await amount(page, "web 2").fill("88.76 kg");
  await amount(page, "web 2").press("Enter");
  await expect(amount(page, "web 2")).toHaveAttribute("aria-invalid", "true");
  await expect(card(page, "Counterweight web 2").getByRole("alert")).toHaveText(/unbalance|kg m/);
  await amount(page, "web 2").fill("2 oz in");
  await amount(page, "web 2").press("Enter");
  await expect(card(page, "Counterweight web 2").getByRole("alert")).toHaveCount(0);
  await expect(amount(page, "web 2")).toHaveValue("2 oz in");
});

test("the optimum comes with its proof, is adopted and undone; a locked weight stays", async ({
  studio,
  page,
}) => {
  await open(page, studio.address);
  await page.getByRole("button", { name: "Lock web 2" }).click();
  await page.getByRole("button", { name: "Optimise", exact: true }).click();
  const answer = page.getByRole("region", { name: "Optimise" });
  await expect(answer.getByRole("heading", { name: "Optimum found and proved" })).toBeVisible();
  await expect(answer.getByRole("table", { name: "Before and after" })).toContainText("Couple");
  await expect(answer).toContainText("no choice of these devices");
  await expect(answer).toContainText("crank angles");
  await expect(answer.getByRole("row", { name: /^web 2/ })).toHaveCount(0);
  const couple = page.locator("[data-peak=couple] .big");
  const before = await couple.innerText();
  await answer.getByRole("button", { name: "Adopt" }).click();
  await expect(couple).not.toHaveText(before);
  await expect(page.locator("[data-peak=couple] .change")).toHaveClass(/better/);
  await expect(amount(page, "web 2")).toHaveValue("88.76 kg mm");
  await page.locator("body").press("Control+z");
  await expect(couple).toHaveText(before);
  await expect(amount(page, "web 1")).toHaveValue("88.76 kg mm");
});

test("limits that cannot hold are told with what comes nearest", async ({ studio, page }) => {
  await open(page, studio.address);
  const answer = page.getByRole("region", { name: "Optimise" });
  await answer.getByRole("button", { name: "Add a limit" }).click();
  await answer.getByRole("combobox", { name: "Limit 1: load" }).selectOption("couple");
  await answer.getByRole("textbox", { name: "Limit 1: at most" }).fill("1 N m");
  await answer.getByRole("button", { name: "Optimise", exact: true }).click();
  await expect(answer.getByRole("heading", { name: "The limits cannot hold together" })).toBeVisible();
  await expect(answer).toContainText("3103 N m");
  await expect(answer.getByRole("button", { name: "Adopt" })).toHaveCount(0);
});

test("an order that cannot vanish is told with its proof", async ({ studio, page }) => {
  await open(page, studio.address);
  await page.getByRole("button", { name: "Add an order" }).click();
  await page.getByRole("combobox", { name: "Order 1: load" }).selectOption("couple");
  await page.getByRole("button", { name: "Optimise", exact: true }).click();
  const answer = page.getByRole("region", { name: "Optimise" });
  await expect(answer.getByRole("heading", { name: /cannot vanish/ })).toBeVisible();
  await expect(answer).toContainText("turning against the crank");
  await expect(answer).toContainText("2137 N m");
});

test("a shaft is added, slid and removed", async ({ studio, page }) => {
  await open(page, studio.address);
  await page.getByRole("button", { name: "Add shaft" }).click();
  const shaft = card(page, "Balance shaft shaft -1");
  await expect(shaft).toContainText("against it");
  const before = await force(page).innerText();
  const slider = shaft.getByRole("slider", { name: "Amount" });
  await slider.focus();
  await slider.press("PageUp");
  await expect(force(page)).not.toHaveText(before);
  await shaft.getByRole("button", { name: "Remove shaft -1" }).click();
  await expect(shaft).toHaveCount(0);
  await expect(force(page)).toHaveText(before);
});

test("an arrangement is picked on the front and adopted", async ({ studio, page }) => {
  await open(page, studio.address);
  const region = page.getByRole("region", { name: "Arrangements" });
  await region.getByRole("combobox", { name: "Judge by: load" }).selectOption("couple");
  await region.getByRole("button", { name: "Add a limit" }).click();
  await expect(region.getByRole("combobox", { name: "Limit 1: load" })).toHaveValue("couple");
  await region.getByRole("textbox", { name: "Limit 1: at most" }).fill("2.5 kN m");
  await page.getByRole("button", { name: "Compare arrangements" }).click();
  await expect(region.getByRole("heading", { name: /^No\. \d+:/ })).toBeVisible();
  const title = region.getByRole("heading", { name: /^No\. \d+:/ });
  // The first point of the front adds nothing.
  const [nothing] = await points(region);
  await page.mouse.click(...nothing!);
  await expect(title).toHaveText("No. 1: nothing added");
  const shaft = region.getByRole("button", { name: /^\d+\. one first-order/ }).first();
  const name = (await shaft.innerText()).replace(/^\d+\. /, "");
  await shaft.click();
  await expect(title).toContainText(name);
  // Its point is the one that is marked: the click on it keeps it.
  const index = await region
    .getByRole("row", { name: /^\d+\./ })
    .evaluateAll((rows) => rows.findIndex((row) => row.querySelector("[aria-pressed=true]")));
  await page.mouse.click(...nothing!);
  await page.mouse.click(...(await points(region))[index]!);
  await expect(title).toContainText(name);
  // What is adopted is what was compared, whatever is asked next.
  await region.getByRole("combobox", { name: "Shafts, at most" }).selectOption("0");
  await region.getByRole("button", { name: "Adopt this arrangement" }).click();
  await expect(page.getByRole("article", { name: /^Balance shaft/ })).toHaveCount(1);
  await page.locator("body").press("Control+z");
  await expect(page.getByRole("article", { name: /^Balance shaft/ })).toHaveCount(0);
});

test.describe("the short form", () => {
  test.use({ example: "in-line-4-shafts.toml" });

  test("becomes entries that can be slid", async ({ studio, page }) => {
    await open(page, studio.address);
    const before = await force(page).innerText();
    await expect(card(page, "Counterweight web 1").getByRole("slider", { name: "Amount" })).toBeDisabled();
    await page.getByRole("button", { name: "Edit one by one" }).click();
    await expect(card(page, "Counterweight web 1").getByRole("slider", { name: "Amount" })).toBeEnabled();
    await expect(page.getByRole("article", { name: /^Counterweight/ })).toHaveCount(8);
    await expect(force(page)).toHaveText(before);
  });
});

test("directions count from the throw, the same before and after they are adopted", async ({
  studio,
  page,
}) => {
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "inline three", "in-line three");
  await page.getByRole("tab", { name: "Balance" }).click();
  const slider = (name: string) =>
    card(page, `Counterweight ${name}`).getByRole("slider", { name: "Direction from the throw" });
  for (const name of ["throw 1", "throw 2", "throw 3"]) await expect(slider(name)).toHaveValue("180");
  await page.getByRole("button", { name: "Optimise", exact: true }).click();
  const answer = page.getByRole("region", { name: "Optimise" });
  const cells = answer.getByRole("row", { name: /^throw/ }).locator("td:last-child");
  await expect(cells).toHaveText([/^179\.1° from throw$/, /^180\.0° from throw$/, /^180\.9° from throw$/]);
  await answer.getByRole("button", { name: "Adopt" }).click();
  for (const [name, degrees] of Object.entries({ "throw 1": 179.1, "throw 2": 180, "throw 3": 180.9 }))
    await expect(slider(name)).toHaveAttribute("aria-valuetext", `${degrees} degrees from the throw`);
  // What the field shows where the file says nothing is what it means: typed in, nothing changes.
  const before = await force(page).innerText();
  const field = page.getByRole("textbox", { name: "Direction of throw 2" });
  await field.fill((await field.getAttribute("placeholder")) ?? "");
  await field.press("Enter");
  await expect
    .poll(() => page.getByRole("button", { name: /^Undo/ }).getAttribute("aria-label"))
    .toContain("throw 2");
  await expect(force(page)).toHaveText(before);
});
