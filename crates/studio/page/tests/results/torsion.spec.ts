// The crankshaft as it yields, on the Results tab: torsional vibration with a damper that is tried out, tuned and adopted; stress and modes by finite elements.

import type { Page } from "@playwright/test";
import type { StressAnswer, TorsionAnswer } from "../../src/api/types";
import { newEngine, opened } from "../page";
import { expect, test, type Studio } from "../server";

async function open(page: Page, studio: Studio) {
  await page.goto(studio.address);
  await page.getByRole("tab", { name: "Results" }).click();
  await page
    .getByRole("navigation", { name: "Kinds of results" })
    .getByRole("button", { name: "Torsional vibration" })
    .click();
}

test.describe("an engine with a damper", () => {
  test.use({ example: "in-line-6-torsion.toml" });

  test(
    "sliders try a damper, the best setting is found and goes into the file",
    { tag: "@server" },
    async ({ studio, page }) => {
      await open(page, studio);
      const facts = page.locator('dl[aria-label="Torsional vibration in short"]');
      await expect(facts).toContainText("Twist, nose to flywheel");
      for (const title of ["Twist between nose and flywheel", "Vibratory shear stress", "Campbell diagram"])
        await expect(page.locator(`figure[data-plot="${title}"]`)).toBeVisible();

      const before = await facts.textContent();
      const damping = page.getByRole("slider", { name: "Damping" });
      await damping.focus();
      await damping.press("Home");
      await expect(facts).not.toHaveText(before ?? "");
      await page.getByRole("button", { name: "As the file says", exact: true }).click();
      await expect(facts).toHaveText(before ?? "");

      // What is tried stands beside what the file has, and nothing below moves.
      const first = page.locator('figure[data-plot="Twist between nose and flywheel"]');
      const top = async () => (await first.boundingBox())!.y;
      const still = await top();
      await damping.press("End");
      await expect(facts).toContainText("file: ±");
      expect(await top()).toBe(still);
      await page.getByRole("button", { name: "As the file says", exact: true }).click();

      await page.getByRole("button", { name: "Find the best setting" }).click();
      await page.getByRole("button", { name: "Try the best" }).click();
      await page.getByRole("button", { name: "Adopt into the engine file" }).click();
      await page.keyboard.press("Control+s");
      await expect.poll(() => studio.read()).not.toContain('damping = "60 N m s/rad"');
      const adopted = /\[damper\][^[]*\ndamping = "([\d.]+) N m s\/rad"/.exec(await studio.read())?.[1];
      expect(Number(adopted)).toBeGreaterThan(60);

      // No other damping has a smaller peak, a twentieth to either side.
      const peak = async (value: number) => {
        const response = await page.request.post(new URL("/api/torsion", studio.address).href, {
          headers: { "X-Lanchester-Token": studio.token },
          data: { text: await studio.read(), damping: value },
        });
        expect(response.ok()).toBe(true);
        return Math.max(...((await response.json()) as TorsionAnswer).twist.total);
      };
      const best = await peak(Number(adopted));
      for (const factor of [0.95, 1.05]) expect(await peak(factor * Number(adopted))).toBeGreaterThan(best);
    },
  );

  test("the damper is told in the units of the page, and keeps those of the file", async ({
    studio,
    page,
  }) => {
    await open(page, studio);
    const ring = page.getByRole("slider", { name: "Ring inertia" });
    await expect(ring).toHaveAttribute("aria-valuetext", "110 g m²");
    await page.getByLabel("Units of results").selectOption("US");
    await expect(ring).toHaveAttribute("aria-valuetext", /^37[56] lb in²$/);
    await expect(page.getByRole("slider", { name: "Damping" })).toHaveAttribute(
      "aria-valuetext",
      "44.3 lbf ft s/rad",
    );
    const typed = page.getByRole("textbox", { name: "Ring inertia of the damper" });
    await expect(typed).toHaveValue("0.11 kg m2");
    await typed.fill("300 lb in2");
    await typed.press("Enter");
    await expect(ring).toHaveAttribute("aria-valuetext", "300 lb in²");
    // What is tried is adopted in the unit that was typed.
    await ring.focus();
    await ring.press("ArrowRight");
    await expect(typed).toHaveValue("300 lb in2");
    await page.getByRole("button", { name: "Adopt into the engine file" }).click();
    await expect(typed).toHaveValue(/^30[0-9.]+ lb in2$/);
    await expect(typed).not.toHaveValue("300 lb in2");
    await page.keyboard.press("Control+s");
    await expect.poll(() => studio.read()).toMatch(/ring_inertia = "30[0-9.]+ lb in2"/);
    expect(await studio.read()).toContain('damping = "60 N m s/rad"');
  });
});

test.describe("an engine without a crankshaft by sizes", () => {
  test.use({ example: "in-line-3.toml" });

  test("says what is missing", async ({ studio, page }) => {
    await open(page, studio);
    await expect(page.getByRole("heading", { name: "There is no torsional vibration yet" })).toBeVisible();
    await expect(page.getByRole("button", { name: "Add it on the Engine tab" })).toBeVisible();
  });
});

test.describe("an engine with two crankshafts", () => {
  test.use({ example: "in-line-3.toml" });

  test("shows its torsional vibration, and says once what holds of both", async ({ studio, page }) => {
    await page.goto(studio.address);
    await opened(page);
    await newEngine(page, "square four", "square four, two geared counter-turning cranks");
    await page.getByRole("button", { name: "Typical values for all that is missing" }).click();
    await page.getByRole("tab", { name: "Results" }).click();
    await page
      .getByRole("navigation", { name: "Kinds of results" })
      .getByRole("button", { name: "Torsional vibration" })
      .click();
    const criticals = page.getByRole("region", { name: "Critical speeds" });
    await expect(criticals).toBeVisible({ timeout: 30_000 });
    const notes = await criticals.getByRole("listitem").allInnerTexts();
    expect(notes.length).toBeGreaterThan(1);
    expect(new Set(notes).size).toBe(notes.length);
    const mode = page.getByRole("region", { name: "Shape of a torsional mode" });
    const hand = mode.locator("path.hand").first();
    const still = await hand.getAttribute("d");
    await mode.getByRole("button", { name: "Animate" }).click();
    await expect.poll(() => hand.getAttribute("d")).not.toBe(still);
    // The page goes on: nothing of it fell over.
    await page.getByRole("tab", { name: "Engine" }).click();
    await expect(page.getByRole("region", { name: "Engine as a form" })).toBeVisible();
  });
});

test.describe("a crankshaft by finite elements", () => {
  test.use({ example: "single-gas.toml" });

  test("stress over the cycle, its fillets, and modes", { tag: "@server" }, async ({ studio, page }) => {
    test.setTimeout(420_000);
    await page.goto(studio.address);
    await page.getByRole("tab", { name: "Results" }).click();
    await page
      .getByRole("navigation", { name: "Kinds of results" })
      .getByRole("button", { name: "Stress", exact: true })
      .click();
    await expect(page.getByRole("heading", { name: "The crankshaft has no shape yet" })).toBeVisible();
    await page.getByRole("button", { name: "Insert typical values" }).click();

    const compute = page.getByRole("button", { name: "Compute", exact: true });
    await page.getByLabel("Elements across a fillet").selectOption("2");
    await page.getByLabel("Size of elements").fill("30");
    const answered = page.waitForResponse((one) => new URL(one.url()).pathname === "/api/stress");
    await compute.click();
    await expect(page.getByRole("button", { name: "Stop", exact: true })).toBeVisible();
    const fillets = page.getByRole("region", { name: "Largest stress of every fillet over the cycle" });
    await expect(fillets.getByRole("row")).toHaveCount(5, { timeout: 120_000 });

    // The numbers are those of the program, and the picture's largest fillet has the highest one at its angle.
    await page.keyboard.press("Control+s");
    await expect.poll(() => studio.read()).toContain("[crank.body");
    const response = await answered;
    const question = response.request().postDataJSON() as Record<string, unknown>;
    expect(question).toMatchObject({ text: await studio.read(), fillet_elements: 2 });
    expect(question.size).toBeCloseTo(0.03, 12);
    const found = (await response.json()) as StressAnswer;
    const most = Math.max(...found.fillets.map((own) => own.stress?.von_mises ?? 0)) / 1e6;
    await expect(fillets.getByRole("row").nth(1)).toContainText(most.toPrecision(4));
    // Error bands need three meshes, which take minutes: the study begins with its size and ends when it is stopped.
    const bands = fillets.getByRole("button", { name: "Find the error bands" });
    await bands.click();
    await expect(fillets).toContainText(/unknowns|nodes|elements/i, { timeout: 60_000 });
    await fillets.getByRole("button", { name: "Stop" }).click();
    await expect(bands).toBeEnabled({ timeout: 120_000 });
    const surface = page.getByRole("region", { name: "Stress on the surface" });
    const said = surface.getByText(/^Largest in a fillet/);
    await expect(said).toContainText(`${most.toPrecision(3)} MPa`);

    await surface.getByRole("button", { name: "One degree on" }).click();
    await surface.getByRole("group", { name: "Crank angle" }).getByRole("slider").first().fill("90");
    await expect(said).not.toContainText(`${most.toPrecision(3)} MPa`);
    const last = fillets.getByRole("row").nth(4).getByRole("button");
    const name = (await last.textContent()) ?? "";
    await last.click();
    const theta = found.fillets.find((own) => own.name === name)?.theta ?? 0;
    await expect(surface.getByRole("group", { name: "Crank angle" })).toContainText(
      `${((theta * 180) / Math.PI).toFixed(1)}°`,
    );
    await expect(said).toContainText(name);

    await page.getByRole("radio", { name: "Natural modes" }).check({ force: true });
    await compute.click();
    const modes = page.getByRole("region", { name: "Natural frequencies" });
    await expect(modes.getByRole("row")).toHaveCount(11, { timeout: 120_000 });
    await modes.getByRole("button", { name: "mode 2" }).click();
    const mode = page.getByRole("region", { name: "Natural mode", exact: true });
    await expect(mode.getByRole("heading")).toContainText("Mode 2");
    await mode.getByRole("button", { name: "Animate" }).click();
    await expect(mode.getByRole("button", { name: "Stop" })).toBeVisible();
  });
});
