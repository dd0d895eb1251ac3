// What all pictures have in common: where they go, and when a page is ready for one.

import { type Locator, type Page, expect } from "@playwright/test";
import { mkdir } from "node:fs/promises";
import { resolve } from "node:path";
import { figure } from "../tests/page";

export const FOLDER = resolve("../../../docs/src/images/studio");
export const THEMES = ["light", "dark"] as const;
export type Theme = (typeof THEMES)[number];

export const TABS = {
  engine: "Engine",
  view: "3-D view",
  balance: "Balance",
  counterweight: "Counterweight",
  results: "Results",
  studies: "Studies",
  compare: "Compare",
} as const;

export async function start(page: Page, address: string, theme: Theme) {
  await mkdir(FOLDER, { recursive: true });
  await page.addInitScript((wanted) => localStorage.setItem("lanchester-theme", wanted), theme);
  await page.goto(address);
  await expect(figure(page, "Peak force")).toHaveText(/\d/);
}

export async function tab(page: Page, name: keyof typeof TABS) {
  await page.getByRole("tab", { name: TABS[name] }).click();
}

export async function section(page: Page, name: string) {
  await page.getByRole("navigation").getByRole("button", { name, exact: true }).click();
  await expect(page.locator("figure[data-plot]").first()).toBeVisible();
}

/** The crank at an angle at which pistons stand at different heights. */
export async function turned(page: Page, degrees: number) {
  const angle = page.getByRole("group", { name: "Crank angle" }).getByRole("slider").first();
  await angle.fill(String(degrees));
}

/** Scrolled to, below what stays at the top. */
export async function into(first: Locator) {
  await first.evaluate((element) => element.scrollIntoView({ block: "start" }));
}

/** What was scrolled by a click is seen from its top again. */
export async function top(page: Page) {
  await page.evaluate(() => scrollTo(0, 0));
}

/** What is in sight, when nothing is on its way any more and no caret blinks. */
export async function draw(page: Page, name: string) {
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  // At the very edge no part of the page is under the pointer.
  const { width, height } = page.viewportSize() ?? { width: 2, height: 2 };
  await page.mouse.move(width - 1, height - 1);
  // The 3-D view is drawn finely after a while without a change.
  await page.waitForTimeout(1200);
  await page.screenshot({ path: `${FOLDER}/${name}.png`, animations: "disabled", caret: "hide" });
}
