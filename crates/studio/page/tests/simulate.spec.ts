// The Simulate tab: paths of points and torques of gears beside the run.

import { opened } from "./page";
import { expect, test } from "./server";

test.use({ example: "three-cylinder.toml" });

test("the path of a point, and the teeth of the balancer", async ({ studio, page }) => {
  // Teeth need a pressure angle: the file says it.
  const mesh = `\n[[simulation.mesh]]\nshaft = "balancer"\npressure_angle = "20 deg"\nz = "-160 mm"\n`;
  await studio.write((await studio.read()) + mesh);
  await page.goto(studio.address);
  await opened(page);
  await page.getByRole("tab", { name: "Simulate" }).click();
  await page.getByLabel("Length").selectOption("revolutions");
  await page.getByRole("spinbutton", { name: "Revolutions" }).fill("4");
  await page.getByRole("button", { name: "Add a point" }).click();
  await page.getByLabel("x of point 1").fill("350");
  await page.getByLabel("z of point 1").fill("100");
  await page.getByRole("button", { name: "Simulate", exact: true }).click();
  const plots = ["Orbit of 350, 0, 100 mm", "Torques of gears and chains", "Forces of the teeth"];
  for (const title of plots)
    await expect(page.getByText(`${title} in the last period`, { exact: true }).first()).toBeVisible();
  await expect(page.getByText("balancer").first()).toBeVisible();
  // Two of them share a picture; without any there is none.
  await page.getByRole("button", { name: "Add a point" }).click();
  await page.getByRole("button", { name: "Simulate", exact: true }).click();
  // Out of sight a plot keeps what it showed last.
  const orbits = page.getByRole("heading", { name: "Orbits of points of the block in the last period" });
  await orbits.scrollIntoViewIfNeeded();
  await expect(page.getByText("0, 0, 0 mm").first()).toBeVisible();
  await page.getByRole("button", { name: "Remove point 2" }).click();
  await page.getByRole("button", { name: "Remove point 1" }).click();
  await page.getByRole("button", { name: "Simulate", exact: true }).click();
  await expect(page.getByText(/Orbits? of .* in the last period/)).toHaveCount(1);
});
