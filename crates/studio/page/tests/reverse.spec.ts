// An engine that turns the other way: every number stays, and every picture is the mirror image, in the same way in all places.

import type { Locator, Page } from "@playwright/test";
import { field, figure, opened } from "./page";
import { expect, test } from "./server";

test.use({ example: "in-line-4-shafts.toml" });

async function middle(of: Locator): Promise<number> {
  const box = (await of.boundingBox())!;
  return box.x + box.width / 2;
}

async function reverse(page: Page) {
  await page.getByRole("button", { name: "Add to the file", exact: true }).first().click();
  await page.getByRole("button", { name: /^Rotation/ }).click();
  await field(page, "rotation").selectOption("reverse");
  await expect(page.getByText("turns in reverse")).toBeVisible();
}

test.beforeEach(async ({ studio, page }) => {
  // Throws and shafts that are not their own mirror image.
  const text = await studio.read();
  await studio.write(
    `${text}\n[[shaft]]\nname = "aside"\nratio = 1\nx = "20 mm"\ny = "90 mm"\nweights = [{ z = "0 mm", unbalance = "2 kg mm", phase = "60 deg" }]\n`,
  );
  await page.goto(studio.address);
  await opened(page);
});

test("the sketch is mirrored, and the numbers stay", async ({ page }) => {
  const along = page.getByRole("group", { name: "Along the crank, from the free end" });
  const shaft = along.getByRole("button", { name: "Balance shaft aside" });
  const crank = along.locator("circle.centre");
  const arrow = along.locator("path.turning");
  expect(await middle(shaft)).toBeGreaterThan(await middle(crank));
  expect(await middle(arrow)).toBeGreaterThan(await middle(crank));
  const train = page.getByRole("group", { name: /^Crank train of cylinder/ });
  const [pin, axis] = [train.locator("circle.pin").first(), train.locator("circle.pin").last()];
  expect(await middle(pin)).toBeGreaterThan(await middle(axis));
  const before = await Promise.all(
    ["Peak force", "Peak couple", "Roll moment"].map((name) => figure(page, name).innerText()),
  );

  await reverse(page);
  await expect.poll(async () => (await middle(shaft)) - (await middle(crank))).toBeLessThan(0);
  expect(await middle(arrow)).toBeLessThan(await middle(crank));
  expect(await middle(pin)).toBeLessThan(await middle(axis));
  for (const [at, name] of ["Peak force", "Peak couple", "Roll moment"].entries())
    await expect(figure(page, name)).toHaveText(before[at]!);
});

test("the dial of a weight is mirrored, and its slider says the same", async ({ page }) => {
  await page.getByRole("tab", { name: "Balance" }).click();
  const card = page.getByRole("article", { name: "Balance shaft aside" });
  const [weight, rim] = [card.locator("circle.weight"), card.locator("circle.rim")];
  expect(await middle(weight)).toBeGreaterThan(await middle(rim));
  await expect(card.getByRole("slider", { name: "Direction" })).toHaveAttribute(
    "aria-valuetext",
    "60 degrees from x at crank angle 0",
  );
  await page.getByRole("tab", { name: "Engine" }).click();
  await reverse(page);
  await page.getByRole("tab", { name: "Balance" }).click();
  expect(await middle(weight)).toBeLessThan(await middle(rim));
  await expect(card.getByRole("slider", { name: "Direction" })).toHaveAttribute(
    "aria-valuetext",
    "60 degrees from x at crank angle 0",
  );
  // The slider turns it on in the sense of the crank: to the left now.
  const before = await middle(weight);
  await card.getByRole("slider", { name: "Direction" }).focus();
  for (let step = 0; step < 30; step += 1) await page.keyboard.press("ArrowRight");
  await expect.poll(() => middle(weight)).toBeLessThan(before);
});

test("results and the flat view point y to the left", async ({ page }) => {
  const shaft = () =>
    page
      .getByRole("img", { name: "The engine from the front" })
      .locator("polygon", { hasText: "aside" })
      .first();
  await page.addInitScript(() => {
    // No WebGL: the flat view is drawn.
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.reload();
  await opened(page);
  await page.getByRole("tab", { name: "3-D view" }).click();
  const picture = page.getByRole("img", { name: "The engine from the front" });
  await expect(picture).toBeVisible();
  const right = await middle(shaft());
  await page.getByRole("tab", { name: "Engine" }).click();
  await reverse(page);
  await page.getByRole("tab", { name: "3-D view" }).click();
  await expect(picture).toBeVisible();
  await expect.poll(() => middle(shaft())).toBeLessThan(right);
  await page.getByRole("tab", { name: "Results" }).click();
  await expect(page.getByText(/y lateral, to the left/)).toBeVisible();
});
