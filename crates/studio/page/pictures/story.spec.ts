// From a new engine to outlines of its counterweights, in four pictures side by side.

import { newEngine } from "../tests/page";
import { expect, test } from "../tests/server";
import { FOLDER, into, start, tab, top } from "./drawn";

test.use({ example: "" });

test("the story", async ({ page, studio }) => {
  const scenes: { words: string; picture: string }[] = [];
  const scene = async (words: string) => {
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await page.waitForTimeout(700);
    const png = await page.screenshot({ animations: "disabled", caret: "hide" });
    scenes.push({ words, picture: `data:image/png;base64,${png.toString("base64")}` });
  };
  await start(page, studio.address, "light");
  await page.getByRole("button", { name: "New", exact: true }).click();
  const gallery = page.getByRole("dialog", { name: "New engine" });
  await gallery.getByRole("searchbox").fill("three");
  await scene("A new engine from the gallery: the in-line three");
  await page.keyboard.press("Escape");
  await newEngine(page, "three", "in-line three");

  const balance = async () => {
    await tab(page, "balance");
    await page.getByRole("button", { name: "Optimise", exact: true }).click();
    const answer = page.getByRole("region", { name: "Optimise" });
    await expect(answer.getByRole("heading", { name: "Optimum found and proved" })).toBeVisible();
    return answer.getByRole("button", { name: "Adopt" });
  };
  let adopt = await balance();
  await into(page.getByRole("heading", { name: "Optimum found and proved" }));
  await scene("Its counterweights and shafts at their best, with the proof");
  await adopt.click();
  await tab(page, "counterweight");
  await page.getByRole("button", { name: "Add all to start from" }).click();
  await expect(page.getByRole("region", { name: "Sections to start from" })).toHaveCount(0);
  adopt = await balance();
  await adopt.click();
  await tab(page, "counterweight");
  await page.getByRole("button", { name: "Find the best shape" }).click();
  const best = page.getByRole("region", { name: "Best shape" });
  await expect(best).toContainText("the least mass is");
  await best.getByRole("button", { name: "Adopt" }).click();
  await expect(page.locator("path.part")).toBeVisible();
  await top(page);
  await scene("The lightest counterweight that fits the crankcase");
  await tab(page, "view");
  await expect(page.locator('[data-stage="drawn"]')).toBeVisible();
  await scene("And how it turns, with what is left of force and couple");

  const sheet = await page.context().newPage();
  await sheet.setViewportSize({ width: 1600, height: 1000 });
  await sheet.setContent(`<style>
      body { margin: 0; background: #fff; font: 15px system-ui, sans-serif; color: #161b22; }
      main { padding: 16px; display: grid; grid-template-columns: 1fr 1fr; gap: 14px 16px; }
      figure { margin: 0; }
      figcaption { padding: 0 0 6px; font-weight: 600; }
      b { color: #0b5cad; padding-right: 6px; }
      img { display: block; width: 100%; border: 1px solid #d5dae1; border-radius: 8px; }
    </style><main>${scenes
      .map(
        ({ words, picture }, index) =>
          `<figure><figcaption><b>${index + 1}</b>${words}</figcaption><img src="${picture}"></figure>`,
      )
      .join("")}</main>`);
  await sheet
    .locator("img")
    .last()
    .evaluate((image: HTMLImageElement) => image.decode());
  await sheet.locator("main").screenshot({ path: `${FOLDER}/story.png` });
});
