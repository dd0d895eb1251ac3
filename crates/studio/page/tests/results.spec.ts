// The Results tab: every section draws, and every plot zooms, reads out and saves what the program answers.

import type { Download, Locator, Page } from "@playwright/test";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import type { Loads, MountStudy } from "../src/api/types";
import { newEngine, opened, text as written } from "./page";
import { expect, test, type Studio } from "./server";

test.use({ example: "in-line-4-mounts.toml" });

const SECTIONS = ["Forces and couples", "Motion", "Torque", "Bearings", "Mounts", "Inside the crankshaft"];

async function open(page: Page, studio: Studio, section = "Forces and couples") {
  await page.goto(studio.address);
  await page.getByRole("tab", { name: "Results" }).click();
  await page
    .getByRole("navigation", { name: "Kinds of results" })
    .getByRole("button", { name: section })
    .click();
  await expect(page.locator("figure[data-plot]").first()).toBeVisible();
}

function plot(page: Page, title: string): Locator {
  return page.locator(`figure[data-plot="${title}"]`);
}

/** What the server answers itself. */
async function loads(page: Page, studio: Studio, speed?: number): Promise<Loads> {
  const text = await studio.read();
  const response = await page.request.post(new URL("/api/loads", studio.address).href, {
    headers: { "X-Lanchester-Token": studio.token },
    data: { text, samples: 360, ...(speed === undefined ? {} : { speed }) },
  });
  expect(response.ok()).toBe(true);
  return (await response.json()) as Loads;
}

async function saved(page: Page, figure: Locator, format: "SVG" | "PNG" | "CSV"): Promise<Download> {
  const download = page.waitForEvent("download");
  await figure.getByRole("button", { name: `(${format})` }).click();
  return download;
}

async function text(download: Download): Promise<string> {
  return readFile(await download.path(), "utf8");
}

async function table(page: Page, figure: Locator): Promise<{ head: string[]; rows: number[][] }> {
  const lines = (await text(await saved(page, figure, "CSV"))).trim().split("\r\n");
  const [head, ...rows] = lines.map((line) => line.split(","));
  return { head: head ?? [], rows: rows.map((row) => row.map(Number)) };
}

/** The ground of a plot, brought into sight. */
async function ground(figure: Locator): Promise<{ x: number; y: number; width: number; height: number }> {
  const surface = figure.getByRole("slider");
  await surface.evaluate((element) => element.scrollIntoView({ block: "center" }));
  const box = await surface.boundingBox();
  if (!box) throw new Error("the plot has no ground");
  return box;
}

/** Labels along the x axis. */
function labels(figure: Locator): Promise<string[]> {
  return figure.locator("svg[role=img] text.x").allTextContents();
}

test("every section draws", async ({ page, studio }) => {
  const mistakes: string[] = [];
  page.on("pageerror", (error) => mistakes.push(error.message));
  await open(page, studio);
  for (const section of SECTIONS) {
    await page.getByRole("button", { name: section, exact: true }).click();
    const figures = page.locator("figure[data-plot]");
    await expect(figures.first()).toBeVisible();
    const count = await figures.count();
    expect(count, section).toBeGreaterThanOrEqual(3);
    for (let k = 0; k < count; k++) {
      const drawn = figures.nth(k).locator("svg[role=img] path[d^=M]");
      expect(await drawn.count(), `${section}, plot ${k + 1}`).toBeGreaterThan(0);
      // Nothing that is not a number got into a path.
      for (const d of await drawn.evaluateAll((paths) => paths.map((path) => path.getAttribute("d") ?? "")))
        expect(d).not.toMatch(/NaN|Infinity|undefined/);
    }
  }
  expect(mistakes).toEqual([]);
});

test("loads are split by part and by cylinder", { tag: "@server" }, async ({ page, studio }) => {
  await open(page, studio);
  const { parts, cylinders } = await loads(page, studio);
  await page.getByText("By kind of part").click();
  const lines = plot(page, "Vertical force (x)").locator("path.line[style*='--colour']");
  await expect(lines).toHaveCount(1 + parts.length);
  await page.getByText("By cylinder").click();
  await expect(lines).toHaveCount(1 + cylinders.length);
  await expect(page.getByText(/In-line four at/)).toBeVisible();
});

test("a plot zooms by a box, the wheel and keys, and shows all again", async ({ page, studio }) => {
  await open(page, studio);
  const figure = plot(page, "Force on the block");
  const whole = await labels(figure);
  const surface = figure.getByRole("slider");
  const box = await ground(figure);
  const at = (x: number, y: number) => [box.x + x * box.width, box.y + y * box.height] as const;

  await page.mouse.move(...at(0.3, 0.2));
  await page.mouse.down();
  await page.mouse.move(...at(0.6, 0.8), { steps: 4 });
  await page.mouse.up();
  const zoomed = await labels(figure);
  expect(zoomed).not.toEqual(whole);
  expect(Number(zoomed[0])).toBeGreaterThan(90);
  expect(Number(zoomed.at(-1))).toBeLessThan(230);

  await figure.getByRole("button", { name: "Show all" }).click();
  expect(await labels(figure)).toEqual(whole);

  await surface.focus();
  await page.keyboard.press("+");
  expect(await labels(figure)).not.toEqual(whole);
  await page.keyboard.press("Escape");
  expect(await labels(figure)).toEqual(whole);

  await page.mouse.move(...at(0.5, 0.5));
  await page.mouse.wheel(0, -400);
  await expect.poll(() => labels(figure)).not.toEqual(whole);
  await page.mouse.dblclick(...at(0.5, 0.5));
  expect(await labels(figure)).toEqual(whole);

  // A plot that was not taken in hand leaves the wheel to the page.
  const other = plot(page, "Couple on the block").getByRole("slider");
  await other.hover();
  const before = await page.evaluate(() => scrollY);
  await page.mouse.wheel(0, 200);
  await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(before);
});

test("two fingers zoom", async ({ page, studio }) => {
  await open(page, studio);
  const figure = plot(page, "Force on the block");
  const whole = await labels(figure);
  const box = await ground(figure);
  const fingers = await page.context().newCDPSession(page);
  const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", apart: number) =>
    fingers.send("Input.dispatchTouchEvent", {
      type,
      touchPoints:
        type === "touchEnd"
          ? []
          : [
              { x: middle.x - apart, y: middle.y, id: 0 },
              { x: middle.x + apart, y: middle.y, id: 1 },
            ],
    });
  await touch("touchStart", 20);
  for (const apart of [30, 45, 60, 80]) await touch("touchMove", apart);
  await touch("touchEnd", 0);
  await expect.poll(() => labels(figure)).not.toEqual(whole);
});

test(
  "the readout tells what the program answers, at the pointer and by keys",
  { tag: "@server" },
  async ({ page, studio }) => {
    await open(page, studio);
    const { total } = await loads(page, studio);
    const figure = plot(page, "Force on the block");
    const surface = figure.getByRole("slider");
    await surface.focus();
    await ground(figure);
    const edge = await figure.boundingBox();
    await page.keyboard.press("Home");
    for (let k = 0; k < 3; k++) await page.keyboard.press("Shift+ArrowRight");
    await page.keyboard.press("ArrowRight");
    const index = 31;
    const degrees = ((total.trace.theta[index] ?? 0) * 180) / Math.PI;
    await expect(figure.locator(".reading b")).toHaveText(`${degrees.toFixed(1)}°`);
    const value = Math.round(total.trace.force_x[index] ?? 0);
    await expect(surface).toHaveAttribute("aria-valuetext", new RegExp(`vertical \\(x\\) ${value} N`));
    // Reading out moves nothing; Enter takes the crank there.
    expect(await figure.boundingBox()).toEqual(edge);
    await page.keyboard.press("Enter");
    await expect(plot(page, "Couple on the block").locator(".reading b")).toHaveText(
      `${degrees.toFixed(1)}°`,
    );

    const box = await ground(figure);
    await page.mouse.move(box.x + box.width / 4, box.y + 20);
    await expect(figure.locator(".reading b")).toHaveText("90.0°");
    expect(await figure.boundingBox()).toEqual(edge);
  },
);

test("the crank angle is dragged in one plot and moves in all", async ({ page, studio }) => {
  await open(page, studio);
  const figure = plot(page, "Force on the block");
  const box = await ground(figure);
  await page.mouse.move(box.x + 1, box.y + 40);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + 60, { steps: 5 });
  await page.mouse.up();
  await page.mouse.move(0, 0);
  const reading = plot(page, "Roll moment (about z)").locator(".reading b");
  await expect(reading).toHaveText(/^1(79|80)\.\d°$/);
});

test("names in the legend hide and show series", async ({ page, studio }) => {
  await open(page, studio);
  const figure = plot(page, "Force on the block");
  const lines = figure.locator("path.line[style*='--colour']");
  await expect(lines).toHaveCount(2);
  const name = figure.getByRole("button", { name: /lateral/ });
  await name.click();
  await expect(lines).toHaveCount(1);
  await expect(name).toHaveAttribute("aria-pressed", "false");
  await name.click();
  await expect(lines).toHaveCount(2);
});

test(
  "what is seen is saved: a drawing of its own, a picture, and a table of the answer's values",
  { tag: "@server" },
  async ({ page, studio }) => {
    await open(page, studio);
    const { total } = await loads(page, studio);
    const figure = plot(page, "Force on the block");

    const svg = await text(await saved(page, figure, "SVG"));
    const found = await page.evaluate((source) => {
      const drawing = new DOMParser().parseFromString(source, "image/svg+xml");
      const strokes = [...drawing.querySelectorAll("path")].map((path) => path.getAttribute("stroke"));
      return {
        broken: drawing.querySelector("parsererror")?.textContent,
        name: drawing.documentElement.nodeName,
        width: Number(drawing.documentElement.getAttribute("width")),
        height: Number(drawing.documentElement.getAttribute("height")),
        title: drawing.querySelector("title")?.textContent,
        coloured: strokes.filter((stroke) => stroke?.startsWith("rgb")).length,
        words: [...drawing.querySelectorAll("text")].map((one) => one.textContent),
      };
    }, svg);
    expect(found.broken).toBeUndefined();
    expect(found.name).toBe("svg");
    expect(found.title).toBe("Force on the block");
    expect(found.words).toContain("vertical (x)");
    expect(found.words).toContain("Crank angle [°]");
    expect(found.coloured).toBeGreaterThan(2);
    expect(svg).not.toMatch(/var\(|class=|data-screen/);

    const png = await readFile(await (await saved(page, figure, "PNG")).path());
    expect(png.subarray(1, 4).toString()).toBe("PNG");
    expect(png.readUInt32BE(16)).toBe(Math.round(2 * Math.round(found.width)));
    expect(png.readUInt32BE(20)).toBeGreaterThan(400);
    expect(png.length).toBeGreaterThan(5000);

    const { head, rows } = await table(page, figure);
    expect(head).toEqual(["Crank angle [°]", "vertical (x) [N]", "lateral (y) [N]"]);
    expect(rows.length).toBe(total.trace.theta.length);
    for (const [index, [theta, x, y]] of rows.entries()) {
      expect(((theta ?? NaN) * Math.PI) / 180).toBeCloseTo(total.trace.theta[index] ?? NaN, 12);
      expect(x).toBe(total.trace.force_x[index]);
      expect(y).toBe(total.trace.force_y[index]);
    }
  },
);

test(
  "the block moves as the program answers, and its mounts go round in orbits",
  { tag: "@server" },
  async ({ page, studio }) => {
    const waiting = page.waitForResponse((response) => response.url().endsWith("/api/mounts"));
    await open(page, studio, "Mounts");
    const study = (await (await waiting).json()) as MountStudy;
    const last = study.response.speeds.length - 1;
    const orders = study.response.speeds[last]?.orders ?? [];
    // At crank angle zero an order is where its real part says [µm].
    const start = (parts: (readonly [number, number] | undefined)[]) =>
      1e6 * parts.reduce((sum, part) => sum + (part?.[0] ?? 0), 0);

    const centre = await table(page, plot(page, "Displacement of the block over the crank angle"));
    expect(centre.head).toEqual([
      "Crank angle [°]",
      "vertical (x) [µm]",
      "lateral (y) [µm]",
      "along the crank (z) [µm]",
    ]);
    for (const along of [0, 1, 2])
      expect(centre.rows[0]?.[1 + along]).toBeCloseTo(start(orders.map(({ motion }) => motion[along])), 6);

    for (const [mount, name] of study.response.mounts.entries()) {
      const figure = plot(page, `Orbit of “${name}”`);
      const { head, rows } = await table(page, figure);
      expect(head.slice(0, 3)).toEqual([
        "all orders: Crank angle [°]",
        "all orders: lateral (y) [µm]",
        "all orders: vertical (x) [µm]",
      ]);
      const moved = study.points[mount]?.displacement[last] ?? [];
      expect(rows[0]?.[1]).toBeCloseTo(start(moved.map((part) => part[1])), 6);
      expect(rows[0]?.[2]).toBeCloseTo(start(moved.map((part) => part[0])), 6);
    }
    await page.getByText("From the side", { exact: true }).click();
    const first = plot(page, `Orbit of “${study.response.mounts[0]}”`);
    expect((await table(page, first)).head[1]).toBe("all orders: along the crank (z) [µm]");
  },
);

test("keys go to other curves of a plane, and what is zoomed follows the readout", async ({
  page,
  studio,
}) => {
  await open(page, studio, "Mounts");
  const orbit = page.locator("figure[data-plot^='Orbit']").first();
  const surface = orbit.getByRole("slider");
  await surface.focus();
  await page.keyboard.press("PageDown");
  await expect(surface).toHaveAttribute("aria-valuetext", /^all orders/);
  await page.keyboard.press("PageDown");
  await expect(surface).toHaveAttribute("aria-valuetext", /^order /);

  const figure = plot(page, "Displacement of the block over the crank angle");
  await figure.getByRole("slider").focus();
  await page.keyboard.press("Home");
  for (let k = 0; k < 4; k++) await page.keyboard.press("+");
  const zoomed = await labels(figure);
  // What was shown was the middle: now it is the beginning, as wide as before.
  await page.keyboard.press("ArrowRight");
  await expect.poll(async () => (await labels(figure))[0]).not.toBe(zoomed[0]);
  expect(Number((await labels(figure))[0])).toBeLessThan(Number(zoomed[0]));
});

test("the speed slider changes curves", { tag: "@server" }, async ({ page, studio }) => {
  await open(page, studio);
  const figure = plot(page, "Force on the block");
  // The first series lies on top.
  const line = figure.locator("path.line[style*='--colour']").last();
  const [fast, before] = [await table(page, figure), await line.getAttribute("d")];
  const slider = page.getByRole("slider", { name: "Speed", exact: true });
  await slider.fill("3000");
  await expect(line).not.toHaveAttribute("d", before ?? "");
  const slow = await table(page, figure);
  // Inertia grows with the square of the speed: 6000 rpm against 3000 rpm.
  expect((fast.rows[0]?.[1] ?? 0) / (slow.rows[0]?.[1] ?? 1)).toBeCloseTo(4, 9);
  const own = await loads(page, studio, (3000 * Math.PI) / 30);
  expect(slow.rows[0]?.[1]).toBeCloseTo(own.total.trace.force_x[0] ?? NaN, 6);
});

test.describe("without gas and mounts", () => {
  test.use({ example: "in-line-3.toml" });

  test("the tab says what is missing and leads to it", async ({ page, studio }) => {
    await open(page, studio);
    await page.getByRole("button", { name: "Torque", exact: true }).click();
    // The inertia alone turns the crank to and fro.
    await expect(page.getByText("the engine file says nothing of the gas")).toBeVisible();
    await expect(page.getByText("[gas]", { exact: true })).toBeVisible();
    await expect(page.locator("[data-plot='Torque at the crankshaft']")).toBeVisible();
    await expect(page.locator("[data-plot='Pressure in the cylinders']")).toHaveCount(0);
    await expect(page.getByRole("heading", { name: "Fluctuation of the speed and flywheel" })).toBeVisible();
    await page.getByRole("button", { name: "Mounts", exact: true }).click();
    await expect(page.getByRole("heading", { name: "The engine file has no mounts" })).toBeVisible();
    await page.getByRole("button", { name: "Bearings", exact: true }).click();
    await expect(page.getByText("Under inertia alone.")).toBeVisible();
    await page.getByRole("button", { name: "Torque", exact: true }).click();
    await page.getByRole("button", { name: "Add it on the Engine tab" }).click();
    await expect(page.getByRole("tab", { name: "Engine" })).toHaveAttribute("aria-selected", "true");
  });
});

test.describe("latency", () => {
  test.use({ example: "in-line-4.toml" });

  test("from the slider to redrawn plots is measured", { tag: "@server" }, async ({ page, studio }, info) => {
    await open(page, studio);
    const times = await page.evaluate(async () => {
      const slider = document.querySelector<HTMLInputElement>("input#speed");
      const line = [...document.querySelectorAll("figure[data-plot='Force on the block'] path.line[d]")]
        .filter((path) => path.hasAttribute("style"))
        .at(-1);
      if (!slider || !line) throw new Error("no slider or no curve");
      const all: { whole: number; page: number }[] = [];
      for (let k = 0; k < 25; k++) {
        const start = performance.now();
        const drawn = new Promise<number>((done) => {
          const seen = new MutationObserver(() => {
            seen.disconnect();
            // After the frame in which the new curve is painted.
            requestAnimationFrame(() => setTimeout(() => done(performance.now()), 0));
          });
          seen.observe(line, { attributes: true, attributeFilter: ["d"] });
        });
        // Never twice the same: nothing would be redrawn.
        slider.value = String(Number(slider.max) * (0.5 + 0.4 * ((0.618 * all.length) % 1)));
        slider.dispatchEvent(new Event("input", { bubbles: true }));
        const end = await drawn;
        const answers = performance
          .getEntriesByType("resource")
          .filter(({ name }) => name.endsWith("/api/loads"));
        const arrived = Math.max(...answers.map((entry) => (entry as PerformanceResourceTiming).responseEnd));
        all.push({ whole: end - start, page: end - arrived });
        performance.clearResourceTimings();
        await new Promise((done) => setTimeout(done, 60));
      }
      return all;
    });
    const spread = (values: number[]) => {
      const sorted = values.sort((a, b) => a - b).map((value) => Math.round(value * 10) / 10);
      return { median: sorted[Math.floor(sorted.length / 2)], least: sorted[0], most: sorted.at(-1) };
    };
    const record = {
      what: "slider input to painted plots of forces and couples, in-line four [ms]",
      ...spread(times.map((time) => time.whole)),
      page: spread(times.map((time) => time.page)),
      count: times.length,
    };
    await mkdir("test-results", { recursive: true });
    await writeFile("test-results/latency.json", `${JSON.stringify(record, null, 2)}\n`);
    info.annotations.push({ type: "latency", description: JSON.stringify(record) });
    console.log(
      `${record.what}: median ${record.median}, ${record.least} to ${record.most}; ` +
        `of it after the answer arrived: median ${record.page.median}`,
    );
  });
});

test("the strongest number is first, for what is chosen", async ({ studio, page }) => {
  await page.goto(studio.address);
  await page.getByRole("tab", { name: "Results" }).click();
  await page
    .getByRole("navigation", { name: "Kinds of results" })
    .getByRole("button", { name: "What matters most" })
    .click();
  const force = page.getByRole("region", { name: "Peak force" });
  await expect(force.getByRole("row").nth(1)).toContainText("crank radius");
  // A percent of the radius is two of the force, nearly.
  await expect(force.getByRole("row").nth(1)).toContainText(/2\.\d+ %/);

  await page.getByRole("radio", { name: "Mounts" }).check({ force: true });
  await expect(page.getByRole("region", { name: /mount/i }).first()).toContainText("mount stiffness", {
    // Seconds, and more where other tests have the processors.
    timeout: 40_000,
  });
  await page.getByRole("radio", { name: "Peaks on the block" }).check({ force: true });
  await page.getByLabel("every part by itself").check();
  await expect(force).toContainText("throw angle 1");
});

test("rigid-body modes swing, and a map shows orders over speed", async ({ studio, page }) => {
  await open(page, studio, "Mounts");
  const shape = page.getByRole("group", { name: "Shape of a rigid-body mode" });
  await shape.scrollIntoViewIfNeeded();
  const box = shape.locator("svg path.now");
  const still = await box.getAttribute("d");
  expect(still).not.toBe(await shape.locator("svg path.still").getAttribute("d"));
  await expect(shape.getByRole("radio")).toHaveCount(6);
  await shape.getByRole("button", { name: "Animate" }).click();
  await expect.poll(() => box.getAttribute("d")).not.toBe(still);
  await shape.getByRole("button", { name: "Stop" }).click();
  await expect(box).toHaveAttribute("d", still ?? "");
  await shape.getByRole("radio").nth(3).check({ force: true });
  await expect(box).not.toHaveAttribute("d", still ?? "");

  const map = page.locator('figure[data-map="Orders of the forces at the mounts over speed"]');
  await map.locator("svg").hover();
  await expect(map).toContainText(/order [\d/]+ at [\d\u202f]+ rpm: /);
});

test.describe("an in-line three", () => {
  test.use({ example: "in-line-3.toml" });

  test("a finding of the diagnosis puts its remedy into the file, and undo takes it out", async ({
    studio,
    page,
  }) => {
    await page.goto(studio.address);
    await opened(page);
    await newEngine(page, "inline three", "in-line three");
    const before = await written(page);
    expect(before).not.toContain("[[shaft]]");
    await page.getByRole("tab", { name: "Results" }).click();
    const diagnosis = page.getByRole("region", { name: "What shakes, and what removes it" });
    const against = diagnosis.getByRole("button", { name: "Add shaft, against the crank, two planes" });
    await against.click();
    await expect(page.getByText("Add shaft, against the crank, two planes: done")).toBeVisible();
    await expect(against).toHaveCount(0);
    await page.getByRole("tab", { name: "Engine" }).click();
    await expect.poll(() => written(page)).toContain("[[shaft]]");
    await page.getByRole("button", { name: "Undo: Add shaft" }).click();
    await expect.poll(() => written(page)).toBe(before);
  });

  test("what is missing leads to its field on the Engine tab", async ({ studio, page }) => {
    await page.goto(studio.address);
    await opened(page);
    const sections = page.getByRole("navigation", { name: "Kinds of results" });
    for (const [section, path] of [
      ["Mounts", "mount"],
      ["Torsional vibration", "torsion"],
      ["Stress", "crank.body"],
    ] as const) {
      await page.getByRole("tab", { name: "Results" }).click();
      await sections.getByRole("button", { name: section, exact: true }).click();
      await page.getByRole("button", { name: "Add it on the Engine tab" }).click();
      const own = page.locator(`[data-section="${path}"]`);
      await expect(own).toBeVisible();
      await expect.poll(() => own.evaluate((part) => part.contains(document.activeElement)), path).toBe(true);
      await expect(page.locator(":focus")).toBeInViewport();
    }
  });

  test("stars turn with the crank, and cylinders can be switched off", async ({ studio, page }) => {
    await page.goto(studio.address);
    await page.getByRole("tab", { name: "Results" }).click();
    const star = page.locator('figure[data-plot="Order 1 with the crank"]');
    await star.scrollIntoViewIfNeeded();
    const arrows = star.locator("path.arrow");
    await expect(arrows.first()).toBeVisible();
    const count = await arrows.count();
    const shape = () => arrows.evaluateAll((all) => all.map((one) => one.getAttribute("d")));
    const still = await shape();
    const crank = page.getByRole("group", { name: "Crank angle" });
    await crank.getByRole("slider").first().fill("90");
    await expect.poll(shape).not.toEqual(still);
    await crank.getByRole("slider").first().fill("360");
    await expect.poll(shape).toEqual(still);
    await crank.getByRole("button", { name: "Turn" }).click();
    await expect.poll(shape).not.toEqual(still);
    await crank.getByRole("button", { name: "Stop" }).click();
    // Without a cylinder the arrows of the others no longer cancel: that of the engine comes.
    await page
      .getByRole("group", { name: "Cylinders in the stars" })
      .getByRole("button", { name: "2", exact: true })
      .click();
    await expect(page.getByText("without cylinder 2")).toBeVisible();
    await expect(star.locator("text", { hasText: /^2$/ })).toHaveCount(0);
    await page.getByRole("button", { name: "All on" }).click();
    await expect(arrows).toHaveCount(count);
  });
});
