// What a user does on the page, in the words of the tests.

import { type Locator, type Page, expect } from "@playwright/test";

/** Waits until the results of the first engine are there. */
export async function opened(page: Page) {
  await expect(figure(page, "Peak force")).toHaveText(/\d/);
  await expect(page.locator(".cm-content")).toBeVisible();
}

/** A number of the strip that is always seen. */
export function figure(page: Page, name: string): Locator {
  return page
    .getByRole("region", { name: "Loads in short" })
    .locator(".tile", { hasText: name })
    .locator("strong");
}

/** The field of a key. */
export function field(page: Page, path: string): Locator {
  return page.locator(`[data-path="${path}"]`);
}

/** The file's text as the server last read it, with its lines. */
export function text(page: Page): Promise<string> {
  return page.evaluate(() => {
    const content = document.querySelector(".cm-content") as unknown as {
      cmTile?: { view: { state: { doc: { toString(): string } } } };
      cmView?: { view: { state: { doc: { toString(): string } } } };
    };
    const view = (content.cmTile ?? content.cmView)?.view;
    if (!view) throw new Error("no editor");
    return view.state.doc.toString();
  });
}

export async function newEngine(page: Page, search: string, title: string) {
  await page.getByRole("button", { name: "New", exact: true }).click();
  const gallery = page.getByRole("dialog", { name: "New engine" });
  await gallery.getByRole("searchbox").fill(search);
  await gallery.getByRole("button", { name: title, exact: true }).click();
  await expect(gallery).toBeHidden();
  await expect(page.getByRole("region", { name: "Loads in short" })).toHaveAttribute("aria-busy", "false");
}

/** Commits a value as a user does: typed, then Enter. */
export async function type(page: Page, path: string, value: string) {
  await field(page, path).fill(value);
  await field(page, path).press("Enter");
}
