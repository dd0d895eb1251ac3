// The 3-D view: that it draws, turns, names what is picked, and what is left without WebGL.

import type { Page } from "@playwright/test";
import { mkdir, writeFile } from "node:fs/promises";
import { figure, newEngine, opened } from "./page";
import { expect, test } from "./server";

test.use({ example: "in-line-3-counterweights.toml" });

const stage = (page: Page) => page.locator("[data-stage]");
const picture = (page: Page) => page.getByRole("img", { name: "The engine in three dimensions" });

async function openView(page: Page, address: string) {
  await page.goto(address);
  await expect(figure(page, "Peak force")).toHaveText(/\d/);
  await page.getByRole("tab", { name: "3-D view" }).click();
}

/** How many of the picture's points are another colour than its corner, and a sum that tells pictures apart. */
function drawn(page: Page): Promise<{ share: number; sum: number }> {
  return picture(page).evaluate(async (canvas) => {
    const bitmap = await createImageBitmap(canvas as HTMLCanvasElement);
    const copy = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = copy.getContext("2d");
    if (!context) throw new Error("no context");
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    let [other, sum] = [0, 0];
    for (let k = 0; k < data.length; k += 4) {
      const off = [0, 1, 2].some((at) => Math.abs((data[k + at] ?? 0) - (data[at] ?? 0)) > 6);
      if (off) other += 1;
      sum = (sum * 31 + (data[k] ?? 0) + (data[k + 1] ?? 0) + (data[k + 2] ?? 0)) % 1_000_000_007;
    }
    return { share: (4 * other) / data.length, sum };
  });
}

/** The canvas keeps what was drawn, so that a test can read it. */
async function keepPictures(page: Page) {
  await page.addInitScript(() => {
    const usual = HTMLCanvasElement.prototype.getContext as (kind: string, options?: object) => unknown;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      kind: string,
      options?: object,
    ) {
      return usual.call(
        this,
        kind,
        kind === "webgl2" ? { ...options, preserveDrawingBuffer: true } : options,
      );
    } as typeof HTMLCanvasElement.prototype.getContext;
  });
}

test("the engine is drawn and turns", async ({ studio, page }, info) => {
  await keepPictures(page);
  await openView(page, studio.address);
  await expect(stage(page)).toHaveAttribute("data-stage", "drawn");
  await expect.poll(async () => (await drawn(page)).share, { timeout: 20_000 }).toBeGreaterThan(0.1);
  const before = await drawn(page);

  await picture(page).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowRight");
  const angle = page.getByRole("group", { name: "Crank angle" }).locator("output").first();
  await expect(angle).toHaveText("11.0°");
  await expect.poll(async () => (await drawn(page)).sum).not.toBe(before.sum);

  await page.getByRole("button", { name: "Turn" }).click();
  await expect(angle).not.toHaveText("11.0°");
  await expect.poll(() => stage(page).getAttribute("data-frame-time"), { timeout: 20_000 }).toMatch(/^\d/);
  // Recorded, not judged: the machine may have other work.
  await page.waitForTimeout(2000);
  const [frames, between] = await Promise.all(
    ["data-frames", "data-frame-time"].map((name) => stage(page).getAttribute(name)),
  );
  info.annotations.push({ type: "frames", description: `${frames} frames/s, ${between} ms between two` });
  console.log(`3-D view: ${frames} frames/s, ${between} ms between two`);
  await page.getByRole("button", { name: "Stop" }).click();
  const still = await angle.textContent();
  await page.waitForTimeout(300);
  await expect(angle).toHaveText(still ?? "");
});

test.describe("a V8", () => {
  test.use({ example: "" });

  test("at 960 by 540 has its frames recorded", async ({ studio, page }, info) => {
    await page.goto(studio.address);
    await opened(page);
    await page.getByRole("button", { name: "New", exact: true }).click();
    const gallery = page.getByRole("dialog", { name: "New engine" });
    await gallery.getByRole("searchbox").fill("V8");
    await gallery.getByRole("button", { name: /V8/ }).first().click();
    await expect(gallery).toBeHidden();
    await page.getByRole("tab", { name: "3-D view" }).click();
    await expect(stage(page)).toHaveAttribute("data-stage", "drawn");
    await stage(page).evaluate((box) => {
      box.style.width = "960px";
      box.style.height = "540px";
    });
    await expect.poll(async () => (await picture(page).boundingBox())?.width).toBe(960);
    await page.getByRole("button", { name: "Turn" }).click();
    await expect.poll(() => stage(page).getAttribute("data-frame-time"), { timeout: 30_000 }).toMatch(/^\d/);
    await page.waitForTimeout(4000);
    const [frames, between, work, ratio] = await Promise.all(
      ["data-frames", "data-frame-time", "data-frame-work", "data-frame-ratio"].map(async (name) =>
        Number(await stage(page).getAttribute(name)),
      ),
    );
    const record = { what: "3-D view of a V8 at 960 x 540", frames, between, work, ratio };
    await mkdir("test-results", { recursive: true });
    await writeFile("test-results/frames.json", `${JSON.stringify(record, null, 2)}\n`);
    info.annotations.push({ type: "frames", description: JSON.stringify(record) });
    console.log(
      `${record.what}: ${frames} frames/s, ${between} ms between two, ${work} ms of it on the page, ` +
        `${ratio} pixels for each of the screen along each side`,
    );
  });
});

test("the ground of the picture follows the theme", async ({ studio, page }) => {
  await keepPictures(page);
  await openView(page, studio.address);
  await expect(stage(page)).toHaveAttribute("data-stage", "drawn");
  await page.getByRole("button", { name: "Use the dark theme" }).click();
  const corner = () =>
    picture(page).evaluate(async (canvas) => {
      const copy = new OffscreenCanvas(1, 1).getContext("2d");
      if (!copy) throw new Error("no context");
      copy.drawImage(await createImageBitmap(canvas as HTMLCanvasElement, 0, 0, 1, 1), 0, 0);
      return `rgb(${[...copy.getImageData(0, 0, 1, 1).data].slice(0, 3).join(", ")})`;
    });
  const ground = await stage(page).evaluate((box) => getComputedStyle(box).backgroundColor);
  await expect.poll(corner).toBe(ground);
});

test("where less motion is asked for the crank turns only when it is told to", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await openView(page, studio.address);
  await expect(stage(page)).toHaveAttribute("data-stage", "drawn");
  const angle = page.getByRole("group", { name: "Crank angle" }).locator("output").first();
  await page.waitForTimeout(500);
  await expect(angle).toHaveText("0.0°");
  const turn = page.getByRole("button", { name: "Turn" });
  await expect(turn).toHaveAttribute("title", /less motion/);
  await picture(page).focus();
  await page.keyboard.press("ArrowLeft");
  await expect(angle).toHaveText("719.0°");
  await turn.click();
  await expect(angle).not.toHaveText("719.0°");
});

test("arrows carry their numbers, apart from each other", async ({ studio, page }) => {
  await openView(page, studio.address);
  await expect(stage(page)).toHaveAttribute("data-stage", "drawn");
  const labels = stage(page).locator("svg.labels text");
  await expect(labels).toHaveCount(2);
  const cells = await page.locator('[data-line="total"] td').allTextContents();
  const [, , yaw, pitch] = cells.map((cell) => Number(cell.replace("−", "-")));
  const couple = labels.filter({ hasText: /^M / });
  const shown = Number(((await couple.textContent()) ?? "").replace(/[^\d.]/g, ""));
  expect(Math.abs(shown / Math.hypot(yaw ?? NaN, pitch ?? NaN) - 1)).toBeLessThan(0.01);
  const [one, other] = [await labels.nth(0).boundingBox(), await labels.nth(1).boundingBox()];
  if (!one || !other) throw new Error("a label is not drawn");
  const beside = one.x + one.width < other.x || other.x + other.width < one.x;
  expect(beside || Math.abs(one.y - other.y) >= 15).toBe(true);
  await page.getByRole("checkbox", { name: "Each source" }).check();
  await expect(labels).toHaveCount(2);
});

test("rounding has no arrow, and no label lies on another at any angle", async ({ studio, page }) => {
  await page.goto(studio.address);
  await opened(page);
  await newEngine(page, "boxer four", "boxer four");
  await page.getByRole("tab", { name: "3-D view" }).click();
  await expect(stage(page)).toHaveAttribute("data-stage", "drawn");
  await page.getByRole("checkbox", { name: "Roll moment" }).check();
  const labels = stage(page).locator("svg.labels text");
  const angle = page.getByRole("group", { name: "Crank angle" }).getByRole("slider").first();
  await angle.fill("15");
  await expect(labels).toHaveCount(2);
  // The forces of a boxer four cancel: what is left of them is rounding.
  await expect(labels.filter({ hasText: /^F / })).toHaveCount(0);
  for (const side of ["Whole", "Front", "Side"]) {
    await page.getByRole("button", { name: side, exact: true }).click();
    for (let degrees = 0; degrees < 360; degrees += 15) {
      await angle.fill(String(degrees));
      const boxes = await labels.evaluateAll(
        (texts) =>
          new Promise<DOMRect[]>((done) =>
            requestAnimationFrame(() =>
              requestAnimationFrame(() => done(texts.map((one) => one.getBoundingClientRect()))),
            ),
          ),
      );
      for (const [index, a] of boxes.entries())
        for (const b of boxes.slice(0, index)) {
          const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
          const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
          expect(across <= 0 || down <= 2, `${side}, ${degrees} degrees`).toBe(true);
        }
    }
  }
});

test("arrows keep their scale from engine to engine, until it is fitted anew", async ({ studio, page }) => {
  await openView(page, studio.address);
  const scale = page.getByText(/^An arrow of full length is/);
  await expect(scale).toContainText(/\d N or [\d\u202f.]+ N m, whatever the engine\.$/);
  const before = await scale.innerText();
  await newEngine(page, "single", "single, four-stroke, crank counterweight of 50 %");
  await expect(scale).toContainText(before.replace(/ Longer ones are cut\.$/, ""));
  await page.getByRole("button", { name: "Fit to what is shown" }).click();
  await expect(scale).not.toContainText(before);
  await expect(scale).not.toContainText("Longer ones are cut");
});

test("what is hidden is not drawn, and the arrows have their numbers", async ({ studio, page }) => {
  await keepPictures(page);
  await openView(page, studio.address);
  await expect.poll(async () => (await drawn(page)).share, { timeout: 20_000 }).toBeGreaterThan(0.1);
  const total = page.locator('[data-line="total"] td');
  await expect(total).toHaveCount(5);
  await expect(total.first()).toHaveText(/\d/);
  await page.getByRole("checkbox", { name: "Each source" }).check();
  await expect(page.locator('[data-line="reciprocating"] td').first()).toHaveText(/\d/);
  for (const box of await page.getByRole("checkbox").all()) {
    const name = await box.evaluate((input) => input.closest("label")?.textContent?.trim());
    if (name !== "Frame rate") await box.uncheck();
  }
  await expect.poll(async () => (await drawn(page)).share).toBe(0);
});

test("a picked part is named and leads to its input", async ({ studio, page }) => {
  await openView(page, studio.address);
  await expect(stage(page)).toHaveAttribute("data-stage", "drawn");
  await page.getByRole("button", { name: "Front", exact: true }).click();
  const box = await picture(page).boundingBox();
  if (!box) throw new Error("no picture");
  const part = page.getByRole("combobox", { name: "Part" });
  // From the front the piston stands above the middle: from the top of the picture down the first part that is solid is one.
  await page.getByRole("checkbox", { name: "Bores" }).uncheck();
  await page.getByRole("checkbox", { name: "Force", exact: true }).uncheck();
  await expect
    .poll(
      async () => {
        for (let share = 0.04; share < 0.5; share += 0.04) {
          await page.mouse.click(box.x + box.width / 2, box.y + share * box.height);
          const name = await part.locator("option:checked").textContent();
          if (name?.startsWith("piston")) return name;
        }
        return "";
      },
      { timeout: 20_000 },
    )
    .toMatch(/^piston \d$/);
  await expect(page.getByText("piston.mass", { exact: true })).toBeVisible();
  await page.getByRole("button", { name: "Edit", exact: true }).click();
  await expect(page.getByRole("tab", { name: "Engine" })).toHaveAttribute("aria-selected", "true");
  await expect(page.locator('[data-path="piston.mass"]')).toBeFocused();
});

test("parts can be chosen without a pointer", async ({ studio, page }) => {
  await openView(page, studio.address);
  await page.getByRole("combobox", { name: "Part" }).selectOption("rod 2");
  await expect(page.getByText("rod.length", { exact: true })).toBeVisible();
});

test("without WebGL flat views turn, and say why", async ({ studio, page }) => {
  await page.addInitScript(() => {
    const usual = HTMLCanvasElement.prototype.getContext as (kind: string, options?: object) => unknown;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      kind: string,
      options?: object,
    ) {
      return kind.startsWith("webgl") ? null : usual.call(this, kind, options);
    } as typeof HTMLCanvasElement.prototype.getContext;
  });
  await openView(page, studio.address);
  await expect(page.getByText("draws no 3-D pictures")).toBeVisible();
  const rod = page
    .getByRole("img", { name: "The engine from the front" })
    .locator("polygon", { has: page.locator("title", { hasText: "rod 1" }) });
  const before = await rod.getAttribute("points");
  await page.getByRole("button", { name: "One degree on" }).click();
  await expect(rod).not.toHaveAttribute("points", before ?? "");
  await expect(page.locator('[data-line="total"] td').first()).toHaveText(/\d/);
});

test("a lost context leaves the flat views", async ({ studio, page }) => {
  await openView(page, studio.address);
  await expect(stage(page)).toHaveAttribute("data-stage", "drawn");
  await picture(page).evaluate((canvas) =>
    (canvas as HTMLCanvasElement).getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext(),
  );
  await expect(stage(page)).toHaveAttribute("data-stage", "flat");
  await expect(page.getByRole("img", { name: "The engine from the side" })).toBeVisible();
});
