// Stories of the guide's page "Five users, five stories", and the main one: from the gallery to a saved file and its report.

import { execFile } from "node:child_process";
import { readFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { promisify } from "node:util";
import { field, figure, newEngine, opened, text, type } from "./page";
import { expect, PROGRAM, test } from "./server";

test.use({ example: "" });

test("from a new in-line three to a saved file and a report", async ({ studio, page }, info) => {
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "three", "in-line three");
  await expect(page.getByRole("heading", { level: 1 })).toContainText("in-line 3");
  const force = await figure(page, "Peak couple").textContent();
  await type(page, "crank.stroke", "3.2 in");
  await type(page, "name", "My three");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("My three");
  await expect(figure(page, "Peak couple")).not.toHaveText(force ?? "");
  await expect(field(page, "crank.stroke")).toHaveValue("3.2 in");

  await page.keyboard.press("Control+s");
  const dialog = page.getByRole("dialog", { name: "Save as" });
  await dialog.getByLabel("Name of the file").fill("my-three");
  await page.keyboard.press("Enter");
  await expect(page.getByText("Saved my-three.toml")).toBeVisible();
  const saved = await studio.read("my-three.toml");
  expect(saved).toBe(await text(page));
  expect(saved).toContain('stroke = "3.2 in"');
  expect(saved).toContain('name = "My three"');

  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Report" }).click();
  const report = info.outputPath("report.html");
  const download = await waiting;
  expect(download.suggestedFilename()).toBe("my-three.html");
  await download.saveAs(report);
  const html = await readFile(report, "utf8");
  expect(html).toContain("My three");
  expect(html).toContain("<svg");
});

test("from a new in-line three to a balanced engine with outlines of its counterweights", async ({
  studio,
  page,
}, info) => {
  const start = Date.now();
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "three", "in-line three");
  await expect(figure(page, "Force, order 1")).toHaveText(/^0/);
  await expect(figure(page, "Force, order 2")).toHaveText(/^0/);
  await expect(figure(page, "Couple, order 1")).toHaveText(/^564\.6/);
  await expect(figure(page, "Peak couple")).toHaveText(/^849\.3/);
  const bare = await figure(page, "Couple, order 1").textContent();

  const balance = async (before: string | null) => {
    await page.getByRole("tab", { name: "Balance" }).click();
    await page.getByRole("button", { name: "Optimise", exact: true }).click();
    const answer = page.getByRole("region", { name: "Optimise" });
    await expect(answer.getByRole("heading", { name: "Optimum found and proved" })).toBeVisible();
    await expect(answer.getByRole("button", { name: "Adopt" })).toBeInViewport();
    await answer.getByRole("button", { name: "Adopt" }).click();
    await expect(figure(page, "Couple, order 1")).not.toHaveText(before ?? "");
  };
  await balance(bare);
  const points = await figure(page, "Couple, order 1").textContent();

  await page.getByRole("tab", { name: "Counterweight" }).click();
  await page.getByRole("button", { name: "Add all to start from" }).click();
  await expect(page.getByRole("region", { name: "Sections to start from" })).toHaveCount(0);
  // Bodies are heavier than the masses that stood for them: balanced anew, as good as before.
  await expect(figure(page, "Couple, order 1")).not.toHaveText(points ?? "");
  await page.getByRole("button", { name: "To the tab Balance" }).click();
  await balance(await figure(page, "Couple, order 1").textContent());
  await expect(figure(page, "Couple, order 1")).toHaveText(points ?? "");
  await page.getByRole("tab", { name: "Counterweight" }).click();
  await page.getByRole("button", { name: "Find the best shape" }).click();
  const best = page.getByRole("region", { name: "Best shape" });
  await expect(best).toContainText("the least mass is");
  await best.getByRole("button", { name: "Adopt" }).click();
  await expect(page.locator("path.part")).toBeVisible();
  await expect(page.getByRole("table", { name: "Clearances" })).toContainText("kept");
  await expect(page.getByRole("region", { name: "Sections to start from" })).toHaveCount(0);
  for (const format of ["STEP", "DXF"])
    await expect(
      page.getByRole("button", { name: new RegExp(`^Export .* as ${format}$`) }).first(),
    ).toBeEnabled();
  await page.evaluate(() => scrollTo(0, 0));
  await page.screenshot({ path: info.outputPath("outlines.png") });

  await page.getByRole("tab", { name: "Engine" }).click();
  await page.keyboard.press("Control+s");
  await page.getByRole("dialog", { name: "Save as" }).getByLabel("Name of the file").fill("balanced");
  await page.keyboard.press("Enter");
  await expect(page.getByText("Saved balanced.toml")).toBeVisible();
  const saved = await studio.read("balanced.toml");
  expect(saved).toContain("[[counterweight]]");
  expect(saved).toContain("shape = ");

  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Report" }).click();
  const report = info.outputPath("balanced.html");
  await (await waiting).saveAs(report);
  const html = await readFile(report, "utf8");
  expect(html).toContain("The crankshaft");
  expect(html).toContain("swept radius");
  for (const web of [1, 2, 3, 4, 5, 6]) expect(html).toContain(`web ${web}`);

  // What no counterweight reaches turns against the crank: a shaft takes it, with the weights that go with it.
  await expect(figure(page, "Peak couple")).toHaveText(/^817\.3/);
  await page.getByRole("tab", { name: "Results" }).click();
  const diagnosis = page.getByRole("region", { name: "What shakes, and what removes it" });
  await diagnosis.getByRole("button", { name: "Add shaft, against the crank, two planes" }).click();
  await expect(page.getByText("Add shaft, against the crank, two planes: done")).toBeVisible();
  await balance(await figure(page, "Couple, order 1").textContent());
  await expect(figure(page, "Couple, order 1")).toHaveText("0");
  await expect(figure(page, "Peak couple")).toHaveText(/^343\.6/);
  await page.getByRole("tab", { name: "Counterweight" }).click();
  await page.getByRole("button", { name: "Find the best shape" }).click();
  await expect(best).toContainText("the least mass is");
  console.log(`from the gallery to the report in ${((Date.now() - start) / 1000).toFixed(1)} s`);
});

test("the way to outlines goes by keyboard alone", async ({ studio, page }) => {
  await page.goto(studio.address);
  await opened(page);
  /** Tab by tab to a control, as without a mouse. */
  const reach = async (name: RegExp) => {
    const wanted = () =>
      page.evaluate((source) => {
        const at = document.activeElement;
        const said = at?.getAttribute("aria-label") ?? at?.textContent ?? "";
        return at !== document.body && new RegExp(source).test(said.trim());
      }, name.source);
    for (let steps = 0; steps < 80 && !(await wanted()); steps += 1) await page.keyboard.press("Tab");
    expect(await wanted(), `${name} by Tab`).toBe(true);
  };
  const tab = async (name: string, steps: number) => {
    await page.locator("[role=tab][aria-selected=true]").focus();
    for (let step = 0; step < steps; step += 1) await page.keyboard.press("ArrowRight");
    await expect(page.getByRole("tab", { name })).toBeFocused();
  };
  await reach(/^New$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("dialog", { name: "New engine" })).toBeVisible();
  await reach(/in-line three$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("heading", { level: 1 })).toContainText("in-line 3");
  await tab("Balance", 2);
  await reach(/^Optimise$/);
  await page.keyboard.press("Enter");
  const answer = page.getByRole("region", { name: "Optimise" });
  await expect(answer.getByRole("heading", { name: "Optimum found and proved" })).toBeVisible();
  await page.keyboard.press("Tab");
  await reach(/^Adopt$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("tabpanel")).toBeFocused();
  await tab("Counterweight", 1);
  await reach(/^Add all to start from$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("region", { name: "Sections to start from" })).toHaveCount(0);
  await expect(page.getByRole("tabpanel")).toBeFocused();
  await reach(/^Find the best shape$/);
  await page.keyboard.press("Enter");
  const best = page.getByRole("region", { name: "Best shape" });
  await expect(best).toContainText("the least mass is");
  await reach(/^Adopt$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("button", { name: /^web 1/ })).toContainText(/\d g/);
  await page.keyboard.press("Control+s");
  await expect(page.getByLabel("Name of the file")).toBeFocused();
  await page.keyboard.press("Control+a");
  await page.keyboard.type("by-keyboard");
  await page.keyboard.press("Enter");
  await expect(page.getByText("Saved by-keyboard.toml")).toBeVisible();
});

test("an NVH engineer finds what reaches the frame, what matters most for it, and a damper for the crankshaft", async ({
  studio,
  page,
}) => {
  test.setTimeout(150_000);
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "flat crank", "in-line four, flat crank");
  await page.getByRole("tab", { name: "Results" }).click();
  const kinds = page.getByRole("navigation", { name: "Kinds of results" });
  await kinds.getByRole("button", { name: "Mounts" }).click();
  await page.getByRole("button", { name: "Insert typical values" }).click();
  const forces = page.locator('figure[data-plot="Force on the mount “front left”"]');
  /** The curve as it goes into a spreadsheet: a name for each column, and its numbers over speed. */
  const curve = async () => {
    const waiting = page.waitForEvent("download");
    await forces.getByRole("button", { name: "(CSV)" }).click();
    const lines = (await readFile(await (await waiting).path(), "utf8")).trim().split("\r\n");
    return lines.map((line) => line.split(","));
  };
  await expect(forces).toBeVisible();
  const bare = await curve();
  expect(bare[0]?.[0]).toBe("Speed [rpm]");
  expect(bare.length).toBeGreaterThan(50);
  // What a direction does not move is no picture of rounding.
  await expect(
    page.locator('figure[data-plot="Displacement of the block over the speed"]'),
  ).not.toContainText(/e−\d/);
  await expect(page.getByRole("region", { name: "Rigid-body modes of the block" })).not.toContainText(/e−\d/);

  await page.getByRole("button", { name: "Typical values: gas, friction" }).click();
  await expect(page.getByText("Shaken by inertia loads and gas")).toBeVisible();
  const [names, first] = await curve();
  expect(names?.slice(0, 3)).toEqual(["Speed [rpm]", "largest [N]", "order 2 [N]"]);
  // At idle, with the gas and without it.
  const [speed, largest, second] = (first ?? []).map(Number);
  expect(speed).toBeCloseTo(750);
  expect(largest).toBeCloseTo(116, -0.5);
  expect(second).toBeCloseTo(100, -0.5);
  expect(Number(bare[1]?.[1])).toBeCloseTo(10, -0.5);

  await kinds.getByRole("button", { name: "What matters most" }).click();
  await page.getByRole("radio", { name: "Mounts" }).check({ force: true });
  const most = page.getByRole("region", { name: /mount force/ });
  // With the gas at every speed it takes seconds, and the page says so.
  await expect(most.getByRole("row").nth(1)).toContainText("%", { timeout: 60_000 });
  await expect(most).toContainText("mount stiffness");

  await kinds.getByRole("button", { name: "Torsional vibration" }).click();
  await page.getByRole("button", { name: "Insert typical values" }).click();
  const facts = page.locator('dl[aria-label="Torsional vibration in short"]');
  await expect(facts).toContainText("±0.571°");
  await page.getByRole("button", { name: "Add a damper on the Engine tab" }).click();
  await expect(field(page, "damper.type")).toBeFocused();
  await field(page, "damper.type").selectOption("viscous");
  await type(page, "damper.ring_inertia", "0.0045 kg m2");
  await type(page, "damper.hub_inertia", "0.0025 kg m2");
  const damper = page.locator('[data-section="damper"]');
  // What this type needs has its field, and is marked as long as it is empty.
  await expect(damper.getByLabel("Damping", { exact: true })).toHaveAttribute("aria-invalid", "true");
  await type(page, "damper.damping", "2 N m s/rad");
  await expect(page.getByText("No mistakes in the file")).toBeVisible();

  await page.getByRole("tab", { name: "Results" }).click();
  await expect(facts).toContainText("Heat of the damper");
  await expect(facts).toContainText("±0.506°");
  await page.getByRole("button", { name: "Find the best setting" }).click();
  await page.getByRole("button", { name: "Try the best" }).click();
  await expect(facts).toContainText("±0.453°");
  await expect(page.getByRole("slider", { name: "Damping" })).toHaveAttribute("aria-valuetext", /^5\.7/);
  await page.getByRole("button", { name: "Adopt into the engine file" }).click();
  await page.getByRole("tab", { name: "Engine" }).click();
  await expect.poll(() => text(page)).toMatch(/\[damper\][^[]*\ndamping = "5\.7\d* N m s\/rad"/);
});

test("a crank builder learns what to screw onto the pins, and what the balancing machine wants", async ({
  studio,
  page,
}) => {
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "crossplane", "V8, 90 degrees, crossplane");
  await page.getByRole("tab", { name: "Studies" }).click();
  await page.getByRole("navigation", { name: "Studies" }).getByRole("button", { name: "Workshop" }).click();
  const fill = async (fields: Record<string, string>) => {
    for (const [name, value] of Object.entries(fields))
      await page.getByRole("textbox", { name, exact: true }).fill(value);
  };
  // The crank of the engine that is open: nobody need count.
  await expect(page.getByRole("spinbutton", { name: "Pins" })).toHaveValue("4");
  await expect(page.getByRole("spinbutton", { name: "Rods on each" })).toHaveValue("2");
  await fill({
    "Big end of the rod": "370",
    "Bearing shells, if weighed": "40",
    "Small end of the rod": "180",
    Piston: "430",
    "Piston pin, if weighed": "140",
    "Rings, if weighed": "46",
    "Locks of the pin, if weighed": "4",
    "Oil in a pin [g]": "4",
  });
  const bobweights = page.getByRole("region", { name: "Bobweights", exact: true });
  await expect(bobweights.getByText("1624.0 g")).toHaveCount(4);
  await expect(bobweights).toContainText("50.00 % of the reciprocating masses, derived");
  const printed = page.getByRole("region", { name: "lanchester workshop bobweight" });
  await expect(printed).toContainText(/optimum: two weights at the ends of the crank +469\.37 +5\.40/);

  await page.getByText("Measured on the balancing machine").click();
  await fill({ "Mass of the crank [kg]": "32", "Service speed [rpm]": "6000" });
  await page.getByRole("combobox", { name: /Grade/ }).selectOption("G 6.3");
  await fill({
    "z at bearing 1": "-230",
    "unbalance at bearing 1": "310",
    "angle at bearing 1": "40",
    "z at bearing 2": "230",
    "unbalance at bearing 2": "250",
    "angle at bearing 2": "200",
    "z of plane 1": "-199.5",
    "radius of plane 1": "85",
    "z of plane 2": "199.5",
    "radius of plane 2": "85",
  });
  const warning = page.getByText("Without the centre of mass the couple is not judged");
  await expect(warning).toBeVisible();
  await fill({ "Its centre of mass, z [mm]": "0" });
  await expect(warning).toBeHidden();
  const grade = page.getByRole("region", { name: "lanchester workshop grade" });
  await expect(grade).toContainText(/first +-230\.00 +160\.4 +310\.0 +40\.0 +exceeded/);
  await expect(grade).toContainText("the grade is not kept");
  const corrections = page.getByRole("region", { name: "lanchester workshop correct" });
  await expect(corrections).toContainText(/front +add +351\.7 +218\.9 +4\.14/);
  await expect(corrections).toContainText(/rear +add +291\.5 +21\.6 +3\.43/);

  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save the sheet" }).click();
  const sheet = await readFile(await (await waiting).path(), "utf8");
  for (const line of ["pins = 4", "rods = 2", 'oil = "4 g"', 'centre = "0 mm"'])
    expect(sheet).toContain(line);
  await expect(page.getByRole("button", { name: "Print" })).toBeEnabled();
});

test(
  "a crank builder gets the same bobweights from the sheet on the command line",
  { tag: "@server" },
  async () => {
    const sheet = resolve("../../../examples/workshop/v8-bobweight.toml");
    const { stdout } = await promisify(execFile)(PROGRAM, ["workshop", "bobweight", sheet]);
    expect(stdout.match(/pin \d .* 1624\.0$/gm)).toHaveLength(4);
    expect(stdout).toMatch(/optimum: two weights at the ends of the crank +469\.37 +5\.40/);
  },
);

test("a student sees why a single shakes, what a counterweight can do, and what it costs", async ({
  studio,
  page,
}) => {
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "single", "single, four-stroke, crank counterweight of 50 %");
  const tab = (name: string) => page.getByRole("tab", { name }).click();
  const force = figure(page, "Force, order 1");
  /** The first order: what turns with the crank and what against it [N]. */
  const halves = page
    .locator("table", { hasText: "Force against it" })
    .getByRole("row")
    .filter({ has: page.getByRole("rowheader", { name: "1", exact: true }) })
    .getByRole("cell");
  await tab("Results");
  await expect(page.getByRole("region", { name: "What shakes, and what removes it" })).toContainText(
    "5.60 kN of first order, turning against the crank",
  );
  await expect(force).toHaveText(/^5595/);
  await expect(halves.nth(0)).toHaveText(/^0$/);
  await expect(halves.nth(1)).toHaveText(/^5595\s+0°$/);
  await tab("Compare");
  await page.getByRole("button", { name: "Pin this state" }).click();

  // Nothing of the reciprocating mass: both halves of its first order meet along the cylinder. All of it: across.
  for (const [share, ahead] of [
    ["0 %", "0°"],
    ["100 %", "180°"],
  ] as const) {
    await tab("Engine");
    if (share === "0 %") await page.getByRole("heading", { name: "Counterweights" }).click();
    await type(page, "counterweights.reciprocating_share", share);
    await expect(force).toHaveText(/^11.190/);
    await tab("Results");
    await expect(halves.nth(0)).toHaveText(new RegExp(`^5595\\s+${ahead}$`));
    await expect(halves.nth(1)).toHaveText(/^5595\s+0°$/);
  }
  await tab("Compare");
  const numbers = page.getByRole("region", { name: "Headline numbers" });
  await expect(numbers.getByRole("row", { name: /^Force, order 1/ })).toContainText("+100 %");
  await expect(page.locator('figure[data-plot="Hodographs of the force"]')).toBeVisible();
});

test(
  "a researcher has the published figures drawn from computed numbers, and checks the numbers with another program",
  { tag: "@server" },
  async ({ studio, page }) => {
    test.setTimeout(300_000);
    const run = promisify(execFile);
    await run(PROGRAM, ["validate", "Figure 18", "--figures", "atlas"], { cwd: studio.folder });
    await page.goto(pathToFileURL(join(studio.folder, "atlas", "index.html")).href);
    const picture = page.getByRole("img").first();
    await expect(picture).toBeVisible();
    expect(await picture.evaluate((image) => image.getBoundingClientRect().width)).toBeGreaterThan(200);
    const values = await readFile(join(studio.folder, "atlas", "twin-thesis-figure-18.csv"), "utf8");
    expect(values.split("\n").length).toBeGreaterThan(300);

    // Every row that the example recomputes is in these. What it does not know, finite elements above all, takes minutes.
    let [computed, all, agree] = [0, 0, 0];
    for (const part of ["thesis", "flexible-paper Text"]) {
      await run(PROGRAM, ["validate", part, "--suite", "suite.json"], { cwd: studio.folder });
      const { stdout } = await run("python3", [resolve("../../../validation/example.py"), "suite.json"], {
        cwd: studio.folder,
      });
      const counts = /(\d+) of (\d+) rows computed, (\d+) agree/.exec(stdout)?.slice(1).map(Number) ?? [];
      computed += counts[0] ?? NaN;
      all += counts[1] ?? NaN;
      agree += counts[2] ?? NaN;
    }
    expect(agree).toBe(computed);
    expect(computed).toBeGreaterThan(0.71 * all);
  },
);
