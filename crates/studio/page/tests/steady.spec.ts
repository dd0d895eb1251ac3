// Nothing moves while numbers change: only plots, pictures and texts may look different.

import type { Page } from "@playwright/test";
import { field, figure } from "./page";
import { expect, test } from "./server";

const SECTIONS = ["Forces and couples", "Motion", "Torque", "Bearings", "Mounts", "Inside the crankshaft"];
/** Places of a slider, as shares of its range: both ends, and numbers of other lengths between. */
const SHARES = [0, 0.03, 0.11, 0.34, 0.62, 0.97, 1];

/** Counts questions under way, so that a test can wait until all are answered. */
function watched(page: Page) {
  let open = 0;
  let last = Date.now();
  const change = (by: number) => (request: { url: () => string }) => {
    if (!request.url().includes("/api/") || request.url().includes("/api/events")) return;
    open += by;
    last = Date.now();
  };
  page.on("request", change(1));
  page.on("requestfinished", change(-1));
  page.on("requestfailed", change(-1));
  return async function answered() {
    // What was just done may ask in a moment.
    last = Date.now();
    await expect
      .poll(() => open === 0 && Date.now() - last > 250, { timeout: 30_000, intervals: [50] })
      .toBe(true);
  };
}

/** Remembers where everything stands that is neither drawn (bars are, too) nor a piece of text within a line. */
async function remember(page: Page) {
  await page.evaluate(() => {
    const drawn = "svg, canvas, figure[data-plot] .canvas, .cm-editor, .bar";
    const all = [...document.querySelectorAll("body *")].filter(
      (element) =>
        !element.closest(drawn) &&
        getComputedStyle(element).display !== "inline" &&
        element.getClientRects().length > 0,
    );
    const places = new Map(
      all.map((element) => [
        element,
        { box: element.getBoundingClientRect(), text: element.childElementCount ? "" : element.textContent },
      ]),
    );
    Object.assign(window, { places, placesAt: [scrollX, scrollY] });
  });
}

/** What has another place or size than when it was remembered, or is gone, in words. */
function moved(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const { places, placesAt } = window as unknown as {
      places: Map<Element, { box: DOMRect; text: string | null }>;
      placesAt: [number, number];
    };
    const [dx, dy] = [scrollX - placesAt[0], scrollY - placesAt[1]];
    const words: string[] = [];
    for (const [element, { box: before, text }] of places) {
      const name = `${element.tagName.toLowerCase()}.${element.className}`.replace(/ ?svelte-\w+/g, "");
      const what = `${name} “${(element.textContent ?? "").trim().replace(/\s+/g, " ").slice(0, 50)}”`;
      if (!element.isConnected) {
        words.push(`${what} is gone`);
        continue;
      }
      const now = element.getBoundingClientRect();
      const sticks = [...ancestors(element)].some((one) =>
        ["sticky", "fixed"].includes(getComputedStyle(one).position),
      );
      const [x, y] = sticks ? [now.x, now.y] : [now.x + dx, now.y + dy];
      const by = [x - before.x, y - before.y, now.width - before.width, now.height - before.height];
      // A text alone may have more digits than before, if one of its ends stays.
      const written = text !== "" && text !== null && text !== element.textContent;
      const ends = Math.min(Math.abs(by[0] ?? 0), Math.abs((by[0] ?? 0) + (by[2] ?? 0)));
      if (written && ends < 0.6 && Math.abs(by[1] ?? 0) + Math.abs(by[3] ?? 0) < 0.6) continue;
      if (by.some((one) => Math.abs(one) > 0.6))
        words.push(`${what} by ${by.map((one) => one.toFixed(1)).join(", ")}`);
    }
    // The first few tell what it is: what follows them moves too.
    return words.slice(0, 8);

    function* ancestors(element: Element) {
      for (let one: Element | null = element; one; one = one.parentElement) yield one;
    }
  });
}

/** Takes a slider through its range; nothing else may move. */
async function through(page: Page, answered: () => Promise<void>, slider: string, number = 0) {
  await remember(page);
  for (const share of SHARES) {
    await page
      .locator(slider)
      .nth(number)
      .evaluate((input: HTMLInputElement, at) => {
        const [low, high] = [Number(input.min), Number(input.max)];
        input.value = String(low + at * (high - low));
        input.dispatchEvent(new Event("input", { bubbles: true }));
        input.dispatchEvent(new Event("change", { bubbles: true }));
      }, share);
    await answered();
    expect(await moved(page), `${slider} at ${share} of its range`).toEqual([]);
  }
}

test.describe("with gas and mounts", () => {
  test.use({ example: "in-line-4-mounts.toml" });

  for (const section of SECTIONS) {
    test(`results, ${section}: the speed moves no element`, async ({ page, studio }) => {
      const answered = watched(page);
      await page.goto(studio.address);
      await page.getByRole("tab", { name: "Results" }).click();
      await page.getByRole("navigation").getByRole("button", { name: section, exact: true }).click();
      await expect(page.locator("figure[data-plot]").first()).toBeVisible();
      await answered();
      await through(page, answered, "input#speed");
    });
  }
});

for (const [tab, shown] of [
  ["Engine", ".cm-content"],
  ["3-D view", '[data-stage="drawn"]'],
  ["Balance", "input[type=range]:not(#speed)"],
  ["Counterweight", "main"],
] as const) {
  test(`${tab}: the speed moves no element`, async ({ page, studio }) => {
    const answered = watched(page);
    await page.goto(studio.address);
    await expect(figure(page, "Peak force")).toHaveText(/\d/);
    await page.getByRole("tab", { name: tab }).click();
    await expect(page.locator(shown).first()).toBeVisible();
    await answered();
    await through(page, answered, "input#speed");
  });
}

test("Balance: the sliders of the devices move no element", async ({ page, studio }) => {
  const answered = watched(page);
  await page.goto(studio.address);
  await page.getByRole("tab", { name: "Balance" }).click();
  const sliders = "main input[type=range]";
  await expect(page.locator(sliders).first()).toBeVisible();
  await answered();
  const count = Math.min(3, await page.locator(sliders).count());
  for (let number = 0; number < count; number++) await through(page, answered, sliders, number);
});

test("Compare: the speed moves no element", async ({ page, studio }) => {
  const answered = watched(page);
  await page.goto(studio.address);
  await expect(figure(page, "Peak force")).toHaveText(/\d/);
  await page.getByRole("tab", { name: "Compare" }).click();
  await page.getByRole("button", { name: "Pin this state" }).click();
  await expect(page.getByRole("heading", { name: "Ranking" })).toBeVisible();
  await answered();
  await through(page, answered, "input#speed");
});

test("on a phone the speed moves no element", async ({ page, studio }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  const answered = watched(page);
  await page.goto(studio.address);
  await expect(figure(page, "Peak force")).toHaveText(/\d/);
  await page.getByRole("tab", { name: "Results" }).click();
  await expect(page.locator("figure[data-plot]").first()).toBeVisible();
  await answered();
  await through(page, answered, "input#speed");
});

test.describe("a damper is added", () => {
  test.use({ example: "in-line-6-torsion.toml" });

  test("its fields are there from the start, and none moves while they are filled", async ({
    page,
    studio,
  }) => {
    await studio.write((await studio.read()).replace(/\[damper\][^[]*/, ""));
    await page.goto(studio.address);
    await expect(figure(page, "Peak force")).toHaveText(/\d/);
    await page.locator("summary", { hasText: "Torsional vibration" }).click();
    await page.getByRole("button", { name: "+ Add damper" }).click();
    await expect(field(page, "damper.type")).toBeFocused();
    const keys = ["type", "ring_inertia", "hub_inertia", "damping", "stiffness", "loss_factor"];
    const box = page.locator('[data-section="damper"]');
    const places = () =>
      box.evaluate((table) => {
        const top = table.getBoundingClientRect().top;
        return [
          table.getBoundingClientRect().height,
          ...[...table.querySelectorAll("[data-path]")].map((one) => one.getBoundingClientRect().top - top),
        ].map((one) => Math.round(one));
      });
    const before = await places();
    expect(before).toHaveLength(1 + keys.length);

    await field(page, "damper.type").selectOption("viscous");
    await expect(field(page, "damper.damping")).toHaveAttribute("aria-invalid", "true");
    await expect(field(page, "damper.stiffness")).toHaveAttribute("placeholder", "not needed");
    expect(await places()).toEqual(before);
    // Half a value is told on the spot, over what follows.
    await field(page, "damper.ring_inertia").fill("0.0045 k");
    await expect(box.locator(".said")).toContainText("unit");
    expect(await places()).toEqual(before);
    await field(page, "damper.ring_inertia").fill("0.0045 kg m2");
    await expect(box.locator(".said")).toBeHidden();
    expect(await places()).toEqual(before);
    await field(page, "damper.hub_inertia").fill("0.0025 kg m2");
    await field(page, "damper.damping").fill("6 N m s/rad");
    await expect(page.getByRole("region", { name: "Messages about the file" })).toContainText("No mistakes");
    expect(await places()).toEqual(before);
    await field(page, "damper.type").selectOption("rubber");
    await expect(field(page, "damper.stiffness")).toHaveAttribute("aria-invalid", "true");
    expect(await places()).toEqual(before);
  });

  test("a click on what lies below a wrong value meets it", async ({ page, studio }) => {
    await page.goto(studio.address);
    await expect(figure(page, "Peak force")).toHaveText(/\d/);
    const hub = field(page, "damper.hub_inertia");
    await page.locator("summary", { hasText: "Torsional vibration" }).click();
    await hub.evaluate((one) => one.scrollIntoView({ block: "center" }));
    await hub.fill("5");
    const said = page.locator(".field", { has: hub }).locator(".said");
    await expect(said).toBeVisible();
    const below = field(page, "damper.damping");
    const { x, y, width, height } = (await below.boundingBox())!;
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await expect(below).toBeFocused();
    expect((await below.boundingBox())!.y).toBe(y);
    await page.mouse.up();
    // Out of hand the lines have their own room.
    await expect.poll(async () => (await below.boundingBox())!.y).toBeGreaterThan(y + 10);
  });
});
