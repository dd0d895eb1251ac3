// Where the points of a plot are on the screen.

import type { Locator } from "@playwright/test";

/** Middles of the points of the first series of points in a plot of `region`, which lies on top [px of the window]. */
export async function points(region: Locator): Promise<[number, number][]> {
  const plot = region.locator("[data-plot]");
  await plot.scrollIntoViewIfNeeded();
  return plot.locator("svg[role=img]").evaluate((svg) => {
    const edge = svg.getBoundingClientRect();
    // Discs of a radius r: "M(x - r) y a r r ...".
    const disc = /M([-\d.]+) ([-\d.]+)a([\d.]+) /g;
    for (const path of [...svg.querySelectorAll("path")].reverse()) {
      const found = [...(path.getAttribute("d") ?? "").matchAll(disc)].map((match): [number, number] => [
        edge.left + Number(match[1]) + Number(match[3]),
        edge.top + Number(match[2]),
      ]);
      if (found.length > 0) return found;
    }
    return [];
  });
}
