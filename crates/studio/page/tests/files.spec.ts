// Files: save and conflicts, two windows, a server that goes and comes back, states as links and files.

import type { Page } from "@playwright/test";
import { readFile } from "node:fs/promises";
import { field, figure, newEngine, opened, text, type } from "./page";
import { expect, test } from "./server";

test.use({ example: "in-line-3.toml" });

test.beforeEach(async ({ studio, page }) => {
  await page.goto(studio.address);
  await opened(page);
});

test("save writes the file, and the mark of unsaved changes goes", async ({ studio, page }) => {
  const mark = page.locator(".unsaved");
  await expect(mark).toBeHidden();
  await type(page, "rod.length", "155 mm");
  await expect(mark).toBeVisible();
  await field(page, "rod.length").press("Control+s");
  await expect(page.getByText("Saved in-line-3.toml")).toBeVisible();
  await expect(mark).toBeHidden();
  expect(await studio.read()).toContain('length = "155 mm"');
  expect(await studio.read()).toContain("# ");
});

test("new and open ask first when changes would be lost", async ({ studio, page }) => {
  await type(page, "rod.length", "155 mm");
  await expect(page.locator(".unsaved")).toBeVisible();
  await page.getByRole("button", { name: "New", exact: true }).click();
  const question = page.getByRole("dialog", { name: "Save your changes first?" });
  await question.getByRole("button", { name: "Cancel" }).click();
  await expect(field(page, "rod.length")).toHaveValue("155 mm");

  await page.getByRole("button", { name: "Open", exact: true }).click();
  await question.getByRole("button", { name: "Save", exact: true }).click();
  const list = page.getByRole("dialog", { name: "Open" });
  await expect(list).toBeVisible();
  expect(await studio.read()).toContain('length = "155 mm"');
  await list.getByRole("button", { name: "Close" }).click();

  await type(page, "rod.length", "156 mm");
  await expect(page.locator(".unsaved")).toBeVisible();
  await page.getByRole("button", { name: "New", exact: true }).click();
  await question.getByRole("button", { name: "Discard changes" }).click();
  await expect(page.getByRole("dialog", { name: "New engine" })).toBeVisible();
  expect(await studio.read()).toContain('length = "155 mm"');
});

test("save as asks before it replaces another file", async ({ studio, page }) => {
  await studio.write('name = "theirs"\n', "other.toml");
  await page.getByRole("button", { name: "Save as" }).click();
  const dialog = page.getByRole("dialog", { name: "Save as" });
  await dialog.getByLabel("Name of the file").fill("other");
  await dialog.getByRole("button", { name: "Save", exact: true }).click();
  const conflict = page.getByRole("dialog", { name: "other.toml is there already" });
  await expect(conflict.getByRole("region", { name: "Difference of lines" })).toContainText(
    'name = "theirs"',
  );
  expect(await studio.read("other.toml")).toBe('name = "theirs"\n');
  await conflict.getByRole("button", { name: "Keep mine, replace the file" }).click();
  await expect(page.getByText("Saved other.toml")).toBeVisible();
  expect(await studio.read("other.toml")).toBe(await text(page));
});

test("a name that leads out of the folder is refused", async ({ studio, page }) => {
  await page.getByRole("button", { name: "Save as" }).click();
  const dialog = page.getByRole("dialog", { name: "Save as" });
  await dialog.getByLabel("Name of the file").fill("../elsewhere.toml");
  await dialog.getByRole("button", { name: "Save", exact: true }).click();
  await expect(dialog.locator(".error")).toBeVisible();
  await expect(dialog.getByLabel("Name of the file")).toHaveAttribute("aria-invalid", "true");
  await expect(studio.read("../elsewhere.toml")).rejects.toThrow();
});

test.describe("another program changes the file", () => {
  const notice = "Another program changed in-line-3.toml";

  test("reload takes it", async ({ studio, page }) => {
    const theirs = (await studio.read()).replace('length = "150 mm"', 'length = "149 mm"');
    await studio.write(theirs);
    await expect(page.getByText(notice)).toBeVisible();
    await page.getByRole("button", { name: "Reload" }).click();
    await expect(field(page, "rod.length")).toHaveValue("149 mm");
    await expect(page.getByText(notice)).toBeHidden();
    await expect(page.locator(".unsaved")).toBeHidden();
    // It can be undone as anything else.
    await page.getByRole("button", { name: /^Undo/ }).click();
    await expect(field(page, "rod.length")).toHaveValue("150 mm");
  });

  test("keep mine keeps it, and the next save replaces the file", async ({ studio, page }) => {
    await type(page, "rod.length", "155 mm");
    await expect(page.locator(".unsaved")).toBeVisible();
    await studio.write((await studio.read()).replace('length = "150 mm"', 'length = "149 mm"'));
    await expect(page.getByText(notice)).toBeVisible();
    await page.getByRole("button", { name: "Keep mine", exact: true }).click();
    await expect(page.getByText(notice)).toBeHidden();
    await expect(field(page, "rod.length")).toHaveValue("155 mm");
    await page.keyboard.press("Control+s");
    await expect(page.getByText("Saved in-line-3.toml")).toBeVisible();
    expect(await studio.read()).toContain('length = "155 mm"');
  });

  test("a save in spite of it shows both, and either can be chosen", async ({ studio, page }) => {
    await type(page, "rod.length", "155 mm");
    await studio.write((await studio.read()).replace('length = "150 mm"', 'length = "149 mm"'));
    await page.keyboard.press("Control+s");
    const conflict = page.getByRole("dialog", { name: notice });
    const lines = conflict.getByRole("region", { name: "Difference of lines" });
    await expect(lines.locator(".theirs")).toContainText('length = "149 mm"');
    await expect(lines.locator(".mine")).toContainText('length = "155 mm"');
    expect(await studio.read()).toContain('length = "149 mm"');
    await conflict.getByRole("button", { name: "Take the file's" }).click();
    await expect(field(page, "rod.length")).toHaveValue("149 mm");

    await type(page, "rod.length", "156 mm");
    await studio.write((await studio.read()).replace('length = "149 mm"', 'length = "148 mm"'));
    await page.keyboard.press("Control+s");
    await conflict.getByRole("button", { name: "Keep mine, replace the file" }).click();
    await expect(page.getByText("Saved in-line-3.toml")).toBeVisible();
    expect(await studio.read()).toContain('length = "156 mm"');
  });
});

test.describe("another program removes the file", () => {
  const told = "Another program removed in-line-3.toml";

  test("saving says so, and it is saved again", async ({ studio, page }) => {
    await type(page, "rod.length", "155 mm");
    await studio.remove();
    await page.keyboard.press("Control+s");
    const dialog = page.getByRole("dialog", { name: told });
    await expect(dialog).toContainText("Your text is still here");
    await expect(studio.read()).rejects.toThrow();
    await dialog.getByRole("button", { name: "Save again" }).click();
    await expect(page.getByText("Saved in-line-3.toml")).toBeVisible();
    expect(await studio.read()).toContain('length = "155 mm"');
    await expect(page.getByText(told)).toBeHidden();
    await expect(page.locator(".unsaved")).toBeHidden();
  });

  test("it is told at once, and saved under another name", async ({ studio, page }) => {
    await studio.remove();
    await expect(page.getByText(told)).toBeVisible();
    // Without a change of one's own there is something to lose too.
    await expect(page.locator(".unsaved")).toBeVisible();
    await page.getByRole("button", { name: "Save as …" }).click();
    const dialog = page.getByRole("dialog", { name: "Save as" });
    await dialog.getByLabel("Name of the file").fill("other");
    await page.keyboard.press("Enter");
    await expect(page.getByText("Saved other.toml")).toBeVisible();
    await expect(page.getByText(told)).toBeHidden();
    expect(await studio.read("other.toml")).toBe(await text(page));
  });

  test("it is let go", async ({ studio, page }) => {
    await studio.remove();
    await page.getByRole("button", { name: "Discard" }).click();
    const gallery = page.getByRole("dialog", { name: "New engine" });
    await gallery.getByRole("button", { name: "in-line three", exact: true }).click();
    await expect(page.getByText(told)).toBeHidden();
    await expect(page.locator(".unsaved")).toBeHidden();
    await expect(studio.read()).rejects.toThrow();
  });

  test("one that came back in another shape is not written over", async ({ studio, page }) => {
    await type(page, "rod.length", "155 mm");
    const theirs = (await studio.read()).replace('length = "150 mm"', 'length = "149 mm"');
    await studio.remove();
    await page.keyboard.press("Control+s");
    const dialog = page.getByRole("dialog", { name: told });
    await expect(dialog).toBeVisible();
    await studio.write(theirs);
    await dialog.getByRole("button", { name: "Save again" }).click();
    const conflict = page.getByRole("dialog", { name: "Another program changed in-line-3.toml" });
    await expect(conflict.locator(".theirs")).toContainText(['length = "149 mm"']);
    expect(await studio.read()).toBe(theirs);
  });
});

test("what is still being typed is saved too, and asked about", async ({ studio, page }) => {
  await field(page, "rod.length").fill("155 mm");
  await page.keyboard.press("Control+s");
  await expect(page.getByText("Saved in-line-3.toml")).toBeVisible();
  expect(await studio.read()).toContain('length = "155 mm"');
  await expect(field(page, "rod.length")).toBeFocused();
  await field(page, "rod.length").fill("156 mm");
  await page.getByRole("button", { name: "New", exact: true }).click();
  await expect(page.getByRole("dialog", { name: "Save your changes first?" })).toBeVisible();
});

test("two windows on one file do not overwrite each other", async ({ studio, page, context }) => {
  const other = await context.newPage();
  await other.goto(studio.address);
  await opened(other);
  await type(page, "rod.length", "155 mm");
  await type(other, "piston.mass", "1.4 kg");
  await page.bringToFront();
  await page.keyboard.press("Control+s");
  await expect(page.getByText("Saved in-line-3.toml")).toBeVisible();
  // The one that saved has nothing to be told.
  await expect(page.getByText("Another program changed")).toBeHidden();

  await other.bringToFront();
  await expect(other.getByText("Another program changed")).toBeVisible();
  await other.keyboard.press("Control+s");
  const conflict = other.getByRole("dialog");
  await expect(conflict.locator(".theirs").first()).toBeVisible();
  expect(await studio.read()).toContain('length = "155 mm"');
  expect(await studio.read()).toContain('mass = "1.5 kg"');
  await conflict.getByRole("button", { name: "Take the file's" }).click();
  await expect(field(other, "rod.length")).toHaveValue("155 mm");
});

test("the server goes and comes back, and nothing is lost", { tag: "@server" }, async ({ studio, page }) => {
  const notice = page.getByText("The studio's server does not answer.");
  const before = await figure(page, "Peak couple").textContent();
  await type(page, "rod.length", "155 mm");
  await expect(figure(page, "Peak couple")).not.toHaveText(before ?? "");
  const couple = await figure(page, "Peak couple").textContent();
  await studio.kill();
  await expect(notice).toBeVisible();
  // The results stay in view, and what is typed meanwhile is kept.
  expect(await figure(page, "Peak couple").textContent()).toBe(couple);
  await type(page, "piston.mass", "1.2 kg");
  await expect(field(page, "piston.mass")).toHaveValue("1.2 kg");
  await studio.run();
  await expect(notice).toBeHidden();
  await expect.poll(() => text(page)).toContain('mass = "1.2 kg"');
  expect(await text(page)).toContain('length = "155 mm"');
  await expect(figure(page, "Peak couple")).not.toHaveText(couple ?? "");
  await page.keyboard.press("Control+s");
  await expect(page.getByText("Saved in-line-3.toml")).toBeVisible();
  expect(await studio.read()).toContain('mass = "1.2 kg"');
});

test(
  "a server started anew has another token: its address opened once is enough",
  { tag: "@server" },
  async ({ studio, page, context }) => {
    await type(page, "rod.length", "155 mm");
    await studio.kill();
    const notice = page.getByText("The studio's server does not answer.");
    await expect(notice).toBeVisible();
    await expect(page.getByText(`lanchester studio in-line-3.toml --port ${studio.port}`)).toBeVisible();
    await studio.run("another-token");
    await page.waitForTimeout(1500);
    await expect(notice).toBeVisible();
    const other = await context.newPage();
    await other.goto(studio.address);
    await expect(notice).toBeHidden();
    await type(page, "piston.mass", "1.2 kg");
    await page.keyboard.press("Control+s");
    await expect(page.getByText("Saved in-line-3.toml")).toBeVisible();
    expect(await studio.read()).toContain('length = "155 mm"');
  },
);

test(
  "a server that goes while it answers loses nothing either",
  { tag: "@server" },
  async ({ studio, page }) => {
    const before = await figure(page, "Peak couple").textContent();
    await type(page, "rod.length", "155 mm");
    await studio.kill();
    await expect(page.getByText("The studio's server does not answer.")).toBeVisible();
    await studio.run();
    await expect(page.getByText("The studio's server does not answer.")).toBeHidden();
    await expect.poll(() => text(page)).toContain('length = "155 mm"');
    await expect(figure(page, "Peak couple")).not.toHaveText(before ?? "");
  },
);

test("a link restores everything in another window", async ({ page, context }) => {
  await type(page, "rod.length", "155 mm");
  await page.getByLabel("Units of results").selectOption("US");
  const slider = page.getByRole("slider", { name: "Speed" });
  await slider.fill("3000");
  await page.getByRole("tab", { name: "Results" }).click();
  await page.getByRole("button", { name: "Share" }).click();
  await page.getByRole("menuitem", { name: /^Copy link/ }).click();
  await expect(page.getByText("Link copied")).toBeVisible();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  await page.getByLabel("Units of results").selectOption("SI");
  const couple = figure(page, "Peak couple");
  const told = await couple.textContent();

  const other = await context.newPage();
  await other.goto(link);
  await expect(other.getByRole("tab", { name: "Results" })).toHaveAttribute("aria-selected", "true");
  await expect(other.getByLabel("Units of results")).toHaveValue("US");
  await expect(other.getByRole("slider", { name: "Speed" })).toHaveAttribute("aria-valuetext", "3000 rpm");
  await other.getByLabel("Units of results").selectOption("SI");
  await expect(figure(other, "Peak couple")).toHaveText(told ?? "");
  await other.getByRole("tab", { name: "Engine" }).click();
  await expect(field(other, "rod.length")).toHaveValue("155 mm");
  // It is a copy that belongs to no file yet.
  await expect(other.locator(".unsaved")).toBeVisible();
});

test("a state as a file is opened again", async ({ page }, info) => {
  await type(page, "rod.length", "155 mm");
  await expect.poll(() => text(page)).toContain('"155 mm"');
  await page.getByRole("button", { name: "Share" }).click();
  const waiting = page.waitForEvent("download");
  await page.getByRole("menuitem", { name: /^Download state/ }).click();
  const state = info.outputPath("kept.state.json");
  await (await waiting).saveAs(state);
  expect(JSON.parse(await readFile(state, "utf8")).text).toContain('"155 mm"');

  await page.keyboard.press("Control+s");
  await expect(page.getByText("Saved in-line-3.toml")).toBeVisible();
  await newEngine(page, "single", "single with two first-order balance shafts");
  await expect(field(page, "rod.length")).not.toHaveValue("155 mm");
  await page.getByRole("button", { name: "Open", exact: true }).click();
  await page.getByLabel("File from this computer").setInputFiles(state);
  await expect(field(page, "rod.length")).toHaveValue("155 mm");
});

test.describe("a draft", () => {
  /** As a user who is asked whether to leave, and does. */
  async function reload(page: Page) {
    await page.reload();
    await opened(page);
  }

  test.beforeEach(({ page }) => {
    page.on("dialog", (question) => void question.accept());
  });

  test("survives a reload, and is let go", async ({ studio, page }) => {
    const saved = await studio.read();
    await type(page, "rod.length", "155 mm");
    await expect(page.locator(".unsaved")).toBeVisible();
    await reload(page);
    await expect(field(page, "rod.length")).toHaveValue("155 mm");
    await expect(page.getByText("Your unsaved changes are back")).toBeVisible();
    expect(await studio.read()).toBe(saved);
    await page.getByRole("button", { name: "Discard draft" }).click();
    await expect(field(page, "rod.length")).toHaveValue("150 mm");
    await expect(page.locator(".unsaved")).toBeHidden();
    await reload(page);
    await expect(field(page, "rod.length")).toHaveValue("150 mm");
    await expect(page.getByText("Your unsaved changes are back")).toBeHidden();
  });

  test("of an engine without a file survives too, and saving ends it", async ({ studio, page }) => {
    await newEngine(page, "single", "single, four-stroke, crank counterweight of 50 %");
    await type(page, "rod.length", "133 mm");
    await reload(page);
    await expect(field(page, "rod.length")).toHaveValue("133 mm");
    await page.keyboard.press("Control+s");
    const dialog = page.getByRole("dialog", { name: "Save as" });
    await dialog.getByLabel("Name of the file").fill("mine");
    await dialog.getByRole("button", { name: "Save", exact: true }).click();
    await expect(page.getByText("Saved mine.toml")).toBeVisible();
    await expect(page.getByText("Your unsaved changes are back")).toBeHidden();
    expect(await studio.read("mine.toml")).toContain('length = "133 mm"');
    await reload(page);
    await expect(page.getByRole("button", { name: "Discard draft" })).toHaveCount(0);
  });

  test("holds what the server has not read yet", { tag: "@server" }, async ({ page }) => {
    // The server is busy: an edit stays on its way until the page goes.
    let busy = true;
    await page.route(
      (address) => address.pathname === "/api/engine",
      (route) =>
        busy && route.request().postData()?.includes('"155 mm"')
          ? new Promise<void>(() => {})
          : route.fallback(),
    );
    await type(page, "rod.length", "155 mm");
    await expect(page.locator(".unsaved")).toBeVisible();
    expect(await text(page)).not.toContain("155 mm");
    busy = false;
    const asked = page.waitForEvent("dialog");
    await page.evaluate(() => setTimeout(() => location.reload()));
    expect((await asked).type()).toBe("beforeunload");
    await expect(page.getByText("Your unsaved changes are back")).toBeVisible();
    await expect(field(page, "rod.length")).toHaveValue("155 mm");
    await expect.poll(() => text(page)).toContain('length = "155 mm"');
    await page.getByRole("button", { name: /^Undo/ }).click();
    await expect(field(page, "rod.length")).toHaveValue("150 mm");
  });

  test("holds what is still being typed", async ({ page }) => {
    await field(page, "rod.length").fill("155 mm");
    await reload(page);
    await expect(field(page, "rod.length")).toHaveValue("155 mm");
    await expect(page.getByText("Your unsaved changes are back")).toBeVisible();
  });

  test("does not go over a file that is newer than it, unless it is told to", async ({ studio, page }) => {
    await type(page, "rod.length", "155 mm");
    await expect(page.locator(".unsaved")).toBeVisible();
    const theirs = (await studio.read()).replace('length = "150 mm"', 'length = "149 mm"');
    await studio.write(theirs);
    await expect(page.getByText("Another program changed in-line-3.toml")).toBeVisible();
    await reload(page);
    await expect(field(page, "rod.length")).toHaveValue("149 mm");
    await expect(page.getByText("The file changed on the disk since.")).toBeVisible();
    await page.getByRole("button", { name: "Take up the draft" }).click();
    await expect(field(page, "rod.length")).toHaveValue("155 mm");
    expect(await studio.read()).toBe(theirs);
    await page.getByRole("button", { name: /^Undo/ }).click();
    await expect(field(page, "rod.length")).toHaveValue("149 mm");
  });
});
