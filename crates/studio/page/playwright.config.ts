import { defineConfig } from "@playwright/test";

/** Chromium of the system: nothing is downloaded. */
const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";

// Every test starts a server of its own (tests/server.ts), in a folder of its own.
export default defineConfig({
  testDir: "tests",
  // Of the studio without a server: `web.config.ts`.
  testIgnore: /web\.spec/,
  outputDir: "test-results",
  reporter: "line",
  // Each test for itself: no file is left to one worker at the end.
  workers: 2,
  fullyParallel: true,
  retries: 0,
  timeout: 60_000,
  expect: { timeout: 10_000 },
  use: {
    viewport: { width: 1280, height: 800 },
    colorScheme: "light",
    locale: "en-GB",
    permissions: ["clipboard-read", "clipboard-write"],
    acceptDownloads: true,
    screenshot: "only-on-failure",
    launchOptions: {
      executablePath: chromium,
      args: [
        "--no-sandbox",
        "--enable-unsafe-swiftshader",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
      ],
    },
  },
});
