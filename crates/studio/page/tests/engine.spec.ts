// The Engine tab: form, sketch and text of the file.

import { field, figure, newEngine, opened, text, type } from "./page";
import { expect, test } from "./server";

test.use({ example: "in-line-3.toml" });

test.beforeEach(async ({ studio, page }) => {
  await page.goto(studio.address);
  await opened(page);
});

test("form and text follow each other, comments stay", async ({ page }) => {
  const before = await text(page);
  const comments = before.split("\n").filter((line) => line.startsWith("#"));
  expect(comments.length).toBeGreaterThan(2);

  await type(page, "rod.length", "6.1 in");
  await expect.poll(() => text(page)).toContain('length = "6.1 in"');
  const after = await text(page);
  expect(after.split("\n").filter((line) => line.startsWith("#"))).toEqual(comments);
  // Nothing but that value is another one.
  expect(after.replace('length = "6.1 in"', 'length = "150 mm"')).toBe(before);

  const editor = page.locator(".cm-content");
  await editor.getByText('"6.1 in"').dblclick();
  await editor.press("Control+a");
  await editor.press("Control+Home");
  await page.keyboard.insertText("# Written by hand.\n");
  await expect.poll(() => text(page)).toContain("# Written by hand.");
  const line = editor.locator(".cm-line", { hasText: 'length = "6.1 in"' });
  await line.click();
  await page.keyboard.press("Home");
  await page.keyboard.press("Shift+End");
  await page.keyboard.insertText('length = "160 mm" # longer');
  await expect(field(page, "rod.length")).toHaveValue("160 mm");

  await type(page, "rod.length", "161 mm");
  await expect.poll(() => text(page)).toContain('length = "161 mm" # longer');
  expect(await text(page)).toContain("# Written by hand.");
});

test("a number has its slider, live on a curve over the ghost of before", async ({ page }) => {
  const peak = figure(page, "Peak couple");
  const before = Number(((await peak.textContent()) ?? "").replace(/[^\d.]/g, ""));
  await page.getByRole("button", { name: "Slider for Mass" }).first().click();
  const sliders = page.getByRole("group", { name: "Sliders of Mass" });
  const said = sliders.locator("[data-live]");
  // Of an in-line three the forces cancel: the couple is what a mass acts on.
  await expect(sliders.getByLabel("Curve")).toHaveValue("couple");
  await expect(said).toHaveText(/Peak before [\d.]+ N m, now [\d.]+ N m/);
  const numbers = async () => ((await said.textContent()) ?? "").match(/[\d.]+/g)?.map(Number) ?? [];
  const [ghost, first] = await numbers();
  expect(ghost).toBe(first);
  expect(Math.abs((ghost ?? 0) / before - 1)).toBeLessThan(2e-3);

  const own = field(page, "piston.mass");
  const written = await own.inputValue();
  const slider = sliders.getByRole("slider", { name: "Mass", exact: true });
  await slider.focus();
  for (let k = 0; k < 20; k++) await page.keyboard.press("ArrowRight");
  await expect(own).not.toHaveValue(written);
  // Its unit stays, and it has no more digits than its steps.
  expect((await own.inputValue()).replace(/[\d.]+/, "")).toBe(written.replace(/[\d.]+/, ""));
  expect((await own.inputValue()).length).toBeLessThan(9);
  await expect.poll(async () => (await numbers())[1]).toBeGreaterThan(1.005 * (ghost ?? 0));
  expect((await numbers())[0]).toBe(ghost);
  const paths = sliders.locator("figure path");
  expect(await paths.count()).toBeGreaterThan(1);
  await expect(sliders.getByText("before", { exact: true })).toBeVisible();

  // The ghost is where it is asked to be; one step of undo takes the move back.
  await sliders.getByRole("button", { name: "Compare from here" }).click();
  await expect.poll(async () => (await numbers())[0]).toBe((await numbers())[1]);
  await page.getByRole("button", { name: "Slider for Mass" }).first().click();
  await expect(sliders).toHaveCount(0);
  await page.keyboard.press("Control+z");
  await expect(own).toHaveValue(written);
});

test("every number of the form has a slider, and nothing else has", async ({ page }) => {
  const wrong = await page.locator(".form .field").evaluateAll((fields) =>
    fields.flatMap((one) => {
      const input = one.querySelector("input, textarea");
      const value = (input as HTMLInputElement | null)?.value ?? "";
      const isNumber = /^[+-]?[\d.]+(e[+-]?\d+)? *[a-z%°]/i.test(value);
      const has = one.querySelector("button.slide") !== null;
      return isNumber === has || /^[+-]?[\d.]+$/.test(value) ? [] : [value];
    }),
  );
  expect(wrong).toEqual([]);
});

test("a wrong value is told beside its field, the results stay", async ({ page }) => {
  const peak = await figure(page, "Peak couple").textContent();
  const stroke = field(page, "crank.radius");
  await stroke.fill("8");
  const said = page.locator(".field", { has: stroke }).locator(".said");
  await expect(said).toContainText("needs a length with its unit");
  await expect(said).toContainText("8 mm");
  await expect(stroke).toHaveAttribute("aria-invalid", "true");
  // The field keeps what was typed while the cursor is in it.
  await expect(stroke).toHaveValue("8");
  await expect(stroke).toBeFocused();
  expect(await figure(page, "Peak couple").textContent()).toBe(peak);
  const messages = page.getByRole("region", { name: "Messages about the file" });
  await expect(messages).toContainText("1 error");

  // The message leads to the field, also from another tab.
  await page.getByRole("tab", { name: "Results" }).click();
  await messages.getByTitle("Go to it").click();
  await expect(stroke).toBeFocused();

  await stroke.pressSequentially("0 mm");
  await expect(stroke).toHaveValue("80 mm");
  await expect(said).toBeHidden();
  await expect(messages).toContainText("No mistakes");
  await expect(figure(page, "Peak couple")).not.toHaveText(peak ?? "");
});

test("a computed number is shown with the digits that count, and stays whole in the file", async ({
  page,
}) => {
  const rod = field(page, "rod.length");
  await type(page, "rod.length", "150.123456789 mm");
  await expect.poll(() => text(page)).toContain('"150.123456789 mm"');
  // What is being typed stays as it is typed.
  await expect(rod).toHaveValue("150.123456789 mm");
  await rod.blur();
  await expect(rod).toHaveValue("150.12 mm");
  await expect(rod).toHaveAttribute("title", "150.123456789 mm");
  await expect(
    page.getByRole("region", { name: "Dimensioned sketch" }).getByRole("button", { name: /^Rod length/ }),
  ).toHaveAttribute("aria-label", /^Rod length 150\.12 mm/);
  const before = await text(page);
  // Typed as it is shown it is the same number, to its last digit.
  await rod.fill("150.12 mm");
  await rod.blur();
  await page.waitForTimeout(400);
  expect(await text(page)).toBe(before);
  await type(page, "rod.length", "151 mm");
  await expect.poll(() => text(page)).toContain('"151 mm"');
});

test("a key that is missing gets its field", async ({ page }) => {
  await field(page, "rod.length").fill("");
  await field(page, "rod.length").blur();
  await expect.poll(() => text(page)).not.toContain('length = "150 mm"');
  const messages = page.getByRole("region", { name: "Messages about the file" });
  await expect(messages).toContainText("error");
  await type(page, "rod.length", "150 mm");
  await expect(messages).toContainText("No mistakes");
});

test("a mistake of the grammar is told, and the form comes back with its mending", async ({ page }) => {
  const editor = page.locator(".cm-content");
  const first = editor.locator(".cm-line", { hasText: "name =" }).first();
  await first.click();
  await page.keyboard.press("End");
  await page.keyboard.press("Backspace");
  const messages = page.getByRole("region", { name: "Messages about the file" });
  await expect(messages).toContainText("error");
  await expect(page.locator(".cm-lintRange-error, .cm-lintPoint-error").first()).toBeAttached();
  await page.keyboard.type('"');
  await expect(messages).toContainText("No mistakes");
  await expect(field(page, "rod.length")).toHaveValue("150 mm");
});

test("undo and redo, by button and by key, say what they do", async ({ page }) => {
  const before = await text(page);
  await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
  await type(page, "rod.length", "170 mm");
  await expect.poll(() => text(page)).toContain('"170 mm"');
  await page.getByRole("button", { name: "Undo: Length" }).click();
  await expect(field(page, "rod.length")).toHaveValue("150 mm");
  expect(await text(page)).toBe(before);
  await page.getByRole("button", { name: "Redo: Length" }).click();
  await expect(field(page, "rod.length")).toHaveValue("170 mm");
  await page.getByRole("tab", { name: "Engine" }).focus();
  await page.keyboard.press("Control+z");
  await expect(field(page, "rod.length")).toHaveValue("150 mm");
  await page.keyboard.press("Control+Shift+z");
  await expect(field(page, "rod.length")).toHaveValue("170 mm");
});

test("the dimension of the field in hand lights up, and a click on one leads to its field", async ({
  page,
}) => {
  const sketch = page.getByRole("region", { name: "Dimensioned sketch" });
  await field(page, "layout.spacing").focus();
  await expect(sketch.locator(".active")).toHaveCount(1);
  await expect(sketch.locator(".active")).toHaveAttribute("aria-label", /^Spacing 100 mm/);
  await sketch.getByRole("button", { name: /^Rod length/ }).click();
  await expect(field(page, "rod.length")).toBeFocused();
  await expect(sketch.locator(".active")).toHaveAttribute("aria-label", /^Rod length 150 mm/);
  // By keyboard alone, too.
  await sketch.getByRole("button", { name: /^Crank radius/ }).focus();
  await page.keyboard.press("Enter");
  await expect(field(page, "crank.radius")).toBeFocused();
});

test("keys are added and removed, entries of lists come and go", async ({ page }) => {
  await expect(field(page, "piston.bore")).toHaveCount(0);
  const piston = page.locator("details", { has: page.getByRole("heading", { name: "Piston", exact: true }) });
  await piston.getByRole("button", { name: /^Add/ }).click();
  await piston.getByRole("button", { name: /^Bore/ }).click();
  await expect(field(page, "piston.bore")).toBeFocused();
  // Nothing is written before there is a value.
  expect(await text(page)).not.toContain("bore");
  await page.keyboard.type("84 mm");
  await page.keyboard.press("Enter");
  await expect.poll(() => text(page)).toContain('bore = "84 mm"');
  await piston.getByRole("button", { name: "Remove Bore" }).click();
  await expect.poll(() => text(page)).not.toContain("bore");

  await newEngine(page, "in-line three", "in-line three");
  await opened(page);
  await page.getByRole("button", { name: "Balance shafts" }).click();
  const shafts = page.locator("details", {
    has: page.getByRole("heading", { name: "Balance shafts", exact: true }),
  });
  await shafts.getByRole("button", { name: "Add shaft" }).click();
  await expect(field(page, "shaft[0].ratio")).toHaveValue("-1");
  await shafts.getByRole("button", { name: "Remove Shaft 1" }).click();
  await expect.poll(() => text(page)).not.toContain("[[shaft]]");
  await expect(page.getByRole("region", { name: "Messages about the file" })).toContainText("No mistakes");
});

test("units of results, not of the file", async ({ page }) => {
  const before = await text(page);
  const force = page
    .getByRole("region", { name: "Loads in short" })
    .locator(".tile")
    .first()
    .locator(".unit");
  await expect(force).toHaveText("N");
  const newton = Number(await figure(page, "Peak couple").textContent());
  await page.getByLabel("Units of results").selectOption("US");
  await expect(force).toHaveText("lbf");
  const foot = Number(await figure(page, "Peak couple").textContent());
  expect(newton / foot).toBeCloseTo(1.3558, 2);
  expect(await text(page)).toBe(before);
  await page.reload();
  await expect(force).toHaveText("lbf");
});

test("the theme changes and is kept", async ({ page }) => {
  const ground = () => page.evaluate(() => getComputedStyle(document.body.parentElement!).backgroundColor);
  const light = await ground();
  await page.getByRole("button", { name: "Use the dark theme" }).click();
  await expect.poll(ground).not.toBe(light);
  await page.reload();
  await opened(page);
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
});

test("the speed slider goes from the lowest to the highest speed", async ({ page }) => {
  await newEngine(page, "in-line four flat", "in-line four, flat crank");
  const slider = page.getByRole("slider", { name: "Speed" });
  await expect(slider).toHaveAttribute("aria-valuetext", /^\d+ rpm$/);
  const highest = Number(await slider.getAttribute("max"));
  await expect(figure(page, "Force, order 2")).toHaveText(/[1-9]/);
  const shown = async () =>
    Number((await figure(page, "Force, order 2").textContent())?.replaceAll("\u202f", ""));
  const full = await shown();
  await slider.fill(String(highest / 2));
  // Forces of inertia go with the square of the speed.
  await expect.poll(async () => (await shown()) / full).toBeCloseTo(0.25, 2);
});

for (const width of [360, 390])
  test(`nothing scrolls sideways on a phone of ${width} px`, async ({ page }) => {
    await page.setViewportSize({ width, height: 800 });
    await newEngine(page, "crossplane", "in-line four, crossplane crank, with a balance shaft");
    await opened(page);
    await field(page, "crank.stroke").fill("8");
    await expect(page.locator(".said").first()).toBeVisible();
    // Whatever can be unfolded is.
    await page.evaluate(() => {
      for (const group of document.querySelectorAll("details")) group.open = true;
    });
    const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(over).toBe(0);
    // The text follows the field in hand without taking the page along.
    await field(page, "rod.length").focus();
    await expect(page.locator(".cm-in-hand")).toHaveText('"103 mm"');
    await expect(field(page, "rod.length")).toBeInViewport();
  });

test("every engine of the gallery has its sketch and no mistakes", async ({ page }) => {
  test.setTimeout(240_000);
  await page.getByRole("button", { name: "New", exact: true }).click();
  const titles = await page.getByRole("dialog").locator("li button").allTextContents();
  expect(titles.length).toBeGreaterThan(30);
  await page.keyboard.press("Escape");
  for (const title of titles) {
    const name = title.trim().replace(/^\d+\s*/, "");
    await page.getByRole("button", { name: "New", exact: true }).click();
    await page.getByRole("dialog").locator("li button", { hasText: name }).first().click();
    const sketch = page.getByRole("region", { name: "Dimensioned sketch" });
    await expect(sketch.locator("figure"), name).toHaveCount(3);
    await expect(page.getByRole("region", { name: "Messages about the file" }), name).toContainText(
      "No mistakes",
    );
    expect(await sketch.innerHTML(), name).not.toContain("NaN");
  }
});

test("the search finds engines, places, numbers and terms", async ({ page }) => {
  await page.keyboard.press("Control+k");
  const search = page.getByRole("dialog", { name: "Search" });
  const asked = search.getByRole("searchbox");
  await asked.fill("balance shafts");
  await expect(search.getByRole("button", { name: /^in-line three with a balance shaft/ })).toBeVisible();
  await expect(search.getByRole("button", { name: /^Balance shaft Term/ })).toBeVisible();
  await asked.fill("cylinder spacing");
  await search.getByRole("button", { name: /^layout\.spacing/ }).click();
  await expect(search).toBeHidden();
  await expect(field(page, "layout.spacing")).toBeFocused();

  await page.getByRole("button", { name: "Search the studio" }).click();
  await asked.fill("oil films");
  await asked.press("Enter");
  await expect(page.getByRole("tab", { name: "Results" })).toHaveAttribute("aria-selected", "true");
  await expect(
    page.getByRole("navigation", { name: "Kinds of results" }).getByRole("button", { name: "Oil films" }),
  ).toHaveAttribute("aria-current", "true");
});

test("a term has its explanation and a link into the book", async ({ page }) => {
  await page.getByRole("tab", { name: "Results" }).click();
  await page.getByRole("button", { name: "Stars of the cylinders" }).click();
  await expect(page.getByText(/where the star closes, the order cancels/)).toBeVisible();
  await page.getByRole("button", { name: "In the book" }).filter({ visible: true }).click();
  const book = page.getByRole("dialog", { name: "The book on star diagram" });
  await expect(book.getByRole("heading", { name: "Star diagrams" })).toBeVisible();
  await expect(book.getByRole("article")).toContainText(/\w{5}/);
  await page.keyboard.press("Escape");
  await expect(book).toBeHidden();

  // The field in hand has its term too.
  await page.getByRole("tab", { name: "Engine" }).click();
  await field(page, "layout.spacing").focus();
  await page.getByRole("button", { name: "In the book: cylinder spacing" }).click();
  await expect(page.getByRole("dialog", { name: "The book on cylinder spacing" })).toContainText("flywheel");
});
