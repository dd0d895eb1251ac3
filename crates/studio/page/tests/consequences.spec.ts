// What other weights do to bearings, bending and balance rates, beside the sliders and under the optimum.

import { expect, test } from "./server";

test.use({ example: "in-line-4-eight-counterweights.toml" });

test("the optimum of force and couple says what it does to the bearings", async ({ studio, page }) => {
  await page.goto(studio.address);
  await page.getByRole("tab", { name: "Balance" }).click();
  const residual = page.getByRole("region", { name: "Residual loads" });
  const live = residual.getByRole("table", { name: "Consequences" });
  // As the file stands: five mains, and nothing has changed.
  await expect(live.getByText(/^main \d$/)).toHaveCount(5);
  await expect(live.getByText("worse")).toHaveCount(0);

  await page.getByRole("textbox", { name: "Mass of web 1" }).fill("100 g");
  await page.keyboard.press("Enter");
  await expect(live.locator("tr[data-change=worse]", { hasText: "main 1" })).toBeVisible();
  await expect(residual).toContainText("Worse than before");
});
