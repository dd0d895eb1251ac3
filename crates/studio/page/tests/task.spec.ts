// The section [balance] in the form: what is to be minimised, limits, orders that must vanish, and what stands wrong in it.

import { field, opened, text } from "./page";
import { expect, test } from "./server";

test.use({ example: "twin-270-choices.toml" });

test.beforeEach(async ({ studio, page }) => {
  await page.goto(studio.address);
  await opened(page);
  const group = page.locator("[id='group-Balance task']");
  if ((await group.getAttribute("open")) === null) await group.locator("> summary").click();
});

test("stages are edited where they stand, weighed ones too", async ({ page }) => {
  const minimise = page.getByRole("group", { name: "Minimise" });
  await expect(minimise.getByLabel("Minimise 1, part 1: criterion")).toHaveValue("couple");
  await minimise.getByLabel("Minimise 1, part 1: value").fill("80 N m");
  await minimise.getByLabel("Minimise 1, part 1: value").press("Enter");
  await expect.poll(() => text(page)).toMatch(/minimise = \[\{.*couple = "80 N m".*\}, "added unbalance"\]/);
  await minimise.getByLabel("Minimise 2: criterion").fill("added mass");
  await minimise.getByLabel("Minimise 2: criterion").press("Enter");
  await expect.poll(() => text(page)).toMatch(/minimise = \[\{.*\}, "added mass"\]/);
  await minimise.getByRole("button", { name: "Add another to Minimise" }).click();
  await expect(minimise.getByLabel("Minimise 3: criterion")).toHaveValue("roll moment");
  await minimise.getByRole("button", { name: "Weigh another criterion with Minimise 3" }).click();
  await expect(minimise.getByLabel("Minimise 3, part 2: value")).toHaveValue(/N/);
  await minimise.getByRole("button", { name: "Remove Minimise 1, part 1" }).click();
  await expect.poll(() => text(page)).toMatch(/minimise = \[\{ ?force = "1000 N" ?\}, "added mass"/);
  // The comments stay.
  expect(await text(page)).toContain("# one of the two shafts");
});

test("limits are added, renamed and removed", async ({ page }) => {
  const group = page.locator("[id='group-Balance task']");
  await group.getByRole("button", { name: "Add to balance", exact: true }).click();
  await group.getByRole("button", { name: /^Limits/ }).click();
  const limits = page.getByRole("group", { name: "Limits" });
  await limits.getByRole("button", { name: "Add one to Limits" }).click();
  await expect(limits.getByLabel("Limits 1: value")).toHaveValue("500 N");
  await limits.getByLabel("Limits 1: criterion").fill("couple order 1");
  await limits.getByLabel("Limits 1: criterion").press("Enter");
  await expect(limits.getByRole("paragraph")).toContainText(/`couple order 1` needs a torque/);
  await expect(limits.getByLabel("Limits 1: value")).toHaveAttribute("aria-invalid", "true");
  await limits.getByLabel("Limits 1: value").fill("40 N m");
  await limits.getByLabel("Limits 1: value").press("Enter");
  await expect(limits.getByLabel("Limits 1: value")).toHaveAttribute("aria-invalid", "false");
  await expect.poll(() => text(page)).toContain('"couple order 1" = "40 N m"');
  await limits.getByRole("button", { name: "Remove Limits 1" }).click();
  await expect.poll(() => text(page)).not.toContain("couple order 1");
});

test("a wrong criterion is told beside its row, and that alone", async ({ page }) => {
  const minimise = page.getByRole("group", { name: "Minimise" });
  await minimise.getByLabel("Minimise 2: criterion").fill("noise");
  await minimise.getByLabel("Minimise 2: criterion").press("Enter");
  await expect(minimise.getByText('there is no criterion "noise"')).toHaveCount(1);
  await expect(minimise.getByLabel("Minimise 2: criterion")).toHaveAttribute("aria-invalid", "true");
  await expect(minimise.getByLabel("Minimise 1, part 1: criterion")).toHaveAttribute("aria-invalid", "false");
  await page.locator("body").press("Control+z");
  await expect(minimise.getByLabel("Minimise 2: criterion")).toHaveValue("added unbalance");
});

test("devices that may be fitted are edited as all lists are", async ({ page }) => {
  await field(page, "balance.shaft[0].y").fill("82 mm");
  await field(page, "balance.shaft[0].y").press("Enter");
  await expect.poll(() => text(page)).toContain('y = "82 mm"');
  await field(page, "balance.most_optional").fill("-1");
  await field(page, "balance.most_optional").press("Enter");
  await expect(field(page, "balance.most_optional")).toHaveAttribute("aria-invalid", "true");
});
