// The Bond graph tab: what a teacher does in a lesson.

import { readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { opened } from "./page";
import { expect, test } from "./server";

test.use({ example: "three-cylinder.toml" });

test.beforeEach(async ({ studio, page }) => {
  await page.goto(studio.address);
  await opened(page);
  await page.getByRole("tab", { name: "Bond graph" }).click();
});

test("a graph file: strokes, equations, power that flows, other poles for another number", async ({
  studio,
  page,
}) => {
  const file = join(studio.folder, "lesson.toml");
  await writeFile(
    file,
    `name = "lesson"
[parameters]
m = "2 kg"
k = "200 N/m"
r = "4 N s/m"
[elements]
hand = { kind = "Se", effort = "10 N" }
v = { kind = "1", domain = "translation" }
mass = { kind = "I", inertia = "m" }
spring = { kind = "C", stiffness = "k" }
damper = { kind = "R", resistance = "r" }
[bonds]
list = ["hand > v", "v > mass", "v > spring", "v > damper"]
[simulation]
duration = "4 s"
`,
  );
  await page.getByLabel("Open a graph file").setInputFiles(file);
  const drawing = page.getByRole("group", { name: "Bond graph lesson" });
  await expect(drawing).toBeVisible();
  // Four bonds, each with its causal stroke; elements with kind and name.
  await expect(drawing.locator("path.stroke")).toHaveCount(4);
  await expect(drawing.getByText("spring", { exact: true })).toBeVisible();
  // The state equations, as mathematics.
  const equations = page.getByRole("region", { name: "Equations" });
  await expect(equations.locator("math").first()).toBeVisible();
  await expect(equations.getByText("State equations")).toBeVisible();
  // s = -r/(2 m) = -1, and the natural frequency sqrt(k/m) = 10 rad/s.
  const numbers = page.getByRole("region", { name: "Numbers and poles" });
  const real = numbers.locator("table tbody tr").first().locator("td").first();
  await expect(real).toHaveText(/^[-\u2212]1\.0000$/);

  // Power flows: the bonds are as wide as what they carry at the cursor.
  const cursor = page.getByRole("slider", { name: "Time of the run" });
  // As it is drawn, whatever the style sheet says.
  const width = () =>
    drawing
      .locator("path.power")
      .nth(1)
      .evaluate((path) => getComputedStyle(path).strokeWidth);
  const before = await width();
  await cursor.focus();
  for (let k = 0; k < 12; k++) await page.keyboard.press("ArrowRight");
  await expect.poll(width).not.toBe(before);
  const widest = () =>
    drawing
      .locator("path.power")
      .evaluateAll((paths) =>
        Math.max(...paths.map((path) => parseFloat(getComputedStyle(path).strokeWidth))),
      );
  await expect.poll(widest).toBeGreaterThan(3);
  await page.getByRole("button", { name: "Play" }).click();
  const playing = await width();
  await expect.poll(width).not.toBe(playing);
  await page.getByRole("button", { name: "Pause" }).click();
  await drawing.getByRole("button", { name: /^Bond spring/ }).hover();
  await expect(page.locator("figcaption")).toContainText(/spring: effort [^]*N, flow [^]*m\/s, power [^]*W/);

  // Another number, other poles: twice the damper, twice the real part.
  await numbers.locator("label", { hasText: /^r/ }).getByRole("spinbutton").fill("8");
  await expect(real).toHaveText(/^[-\u2212]2\.0000$/);
  await expect(page.getByLabel("Text of the graph file")).toHaveValue(/r = "8 N s\/m"/);

  // From the force to the speed: s/m over s^2 + r/m s + k/m.
  const transfer = page.getByRole("region", { name: "Transfer functions" });
  await expect(transfer.getByRole("row", { name: "mass.flow / hand" }).locator("mfrac")).toHaveText(
    "0.5ss2+4s+100",
  );
  // A bond that is clicked shows its curves.
  await drawing.getByRole("button", { name: /^Bond spring/ }).click();
  await expect(page.getByRole("region", { name: "Curves" }).getByText("Effort of spring")).toBeVisible();
  // The changed file can be taken away, and is what the editor shows.
  const [saved] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("region", { name: "Text" }).getByRole("button", { name: "Download" }).click(),
  ]);
  expect(saved.suggestedFilename()).toBe("lesson.toml");
  expect(await readFile(await saved.path(), "utf8")).toContain('r = "8 N s/m"');
});

test("a graph that uses another and reads a table: all opened together", async ({ studio, page }) => {
  const files: Record<string, string> = {
    "whole.toml": `name = "whole"
[tables.push]
file = "push.csv"
x_unit = "s"
y_unit = "N"
[[use]]
graph = "mass.toml"
as = "own"
[elements]
hand = { kind = "MSe", effort = "table(push, t)" }
[bonds]
list = ["hand > own_v"]
`,
    "mass.toml": `name = "mass"
[elements]
v = { kind = "1", domain = "translation" }
m = { kind = "I", inertia = "2 kg" }
[bonds]
list = ["v > m"]
`,
    "push.csv": "0,0\n1,4\n",
  };
  const paths = await Promise.all(
    Object.entries(files).map(async ([name, text]) => {
      const path = join(studio.folder, name);
      await writeFile(path, text);
      return path;
    }),
  );
  await page.getByLabel("Open a graph file").setInputFiles(paths);
  await expect(page.getByRole("group", { name: "Bond graph whole" })).toBeVisible();
  await expect(
    page.getByRole("region", { name: "Drawing" }).getByText("own_m", { exact: true }),
  ).toBeVisible();
  await expect(page.getByText("Opened with it: mass.toml, push.csv.")).toBeVisible();
});

test("the engine's graph, whole and part by part, on a narrow page too", async ({ page }) => {
  const wanted = page.getByRole("region", { name: "Graph of the engine" });
  await wanted.getByRole("combobox").selectOption("fixed");
  await wanted.getByRole("button", { name: "Graph of this engine" }).click();
  const drawing = page.getByRole("group", { name: /^Bond graph Three-cylinder/ });
  await expect(drawing).toBeVisible({ timeout: 30_000 });
  for (const title of ["Block and crank", "Cylinder 3", "Surroundings of the gas"])
    await expect(drawing.locator(".tile", { hasText: title })).toHaveCount(1);
  const whole = await drawing.getAttribute("viewBox");
  await page.getByLabel("Part of the graph").selectOption("Cylinder 2");
  await expect(drawing).not.toHaveAttribute("viewBox", whole ?? "");
  await expect(drawing.getByText("piston2_motion", { exact: true })).toBeInViewport();
  await page.setViewportSize({ width: 420, height: 800 });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(wide).toBeLessThanOrEqual(420);
});
