import { defineConfig } from "@playwright/test";
import tests from "./playwright.config";

// Draws the pictures of the guide: `npm run pictures`.
export default defineConfig({
  ...tests,
  testDir: "pictures",
  outputDir: "test-results/pictures",
  fullyParallel: false,
  timeout: 300_000,
  expect: { timeout: 60_000 },
  use: { ...tests.use, screenshot: "off" },
});
