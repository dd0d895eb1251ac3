// Typical values: buttons of the form and of results that want a section, one step of undo each.

import { newEngine, opened, text } from "./page";
import { expect, test } from "./server";

test.use({ example: "in-line-3.toml" });

test.beforeEach(async ({ studio, page }) => {
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "single", "single, four-stroke, crank counterweight of 50 %");
});

test("a section is inserted with comments, and undo takes it out", async ({ page }) => {
  const before = await text(page);
  expect(before).not.toContain("[gas]");
  const form = page.getByRole("region", { name: "Engine as a form" });
  await form.getByRole("button", { name: "Typical values: gas, friction" }).click();
  await expect.poll(() => text(page)).toContain("[gas]");
  const after = await text(page);
  expect(after).toContain("# Typical values");
  // What the file says stays line by line.
  expect(after.startsWith(before.trimEnd().slice(0, 400))).toBe(true);
  for (const line of before.split("\n")) expect(after).toContain(line);
  await expect(form.getByText("Typical values for gas, friction.")).toBeVisible();
  await expect(form.getByRole("button", { name: "Typical values: gas, friction" })).toBeHidden();

  await page.getByRole("button", { name: /^Undo/ }).click();
  await expect.poll(() => text(page)).toBe(before);
  await expect(form.getByRole("button", { name: "Typical values: gas, friction" })).toBeVisible();
});

test("a result that wants a section offers it where it is missed", async ({ page }) => {
  await page.getByRole("tab", { name: "Results" }).click();
  await page.getByRole("button", { name: "Mounts" }).click();
  await page.getByRole("button", { name: "Insert typical values" }).click();
  await expect(page.getByText("The engine file has no mounts")).toBeHidden();
  await expect(page.getByRole("heading", { name: /mount/i }).first()).toBeVisible();
});

test("all that is missing comes at once, and what cannot be had is told", async ({ page }) => {
  const form = page.getByRole("region", { name: "Engine as a form" });
  await form.getByRole("button", { name: "Typical values for all that is missing" }).click();
  await expect.poll(() => text(page)).toContain("[simulation]");
  await expect(
    form.getByText("shapes of shaft weights is left out: the engine has no balance shafts"),
  ).toBeVisible();
  const messages = page.getByRole("region", { name: "Messages about the file" });
  await expect(messages.getByText(/error/)).toBeHidden();
});
