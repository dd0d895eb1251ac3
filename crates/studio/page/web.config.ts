import { defineConfig } from "@playwright/test";
import config from "./playwright.config";

const place = process.env.LANCHESTER_WEB ?? "";
const all = /\.spec\.ts$/;
const core = /(web|story|files|simulate|exports)\.spec\.ts$/;
const file = /(web|story)\.spec\.ts$/;

// The studio without a server, as `cargo xtask web` builds it. LANCHESTER_WEB names the folder, or its page in one file, which is tried from
// the disk. LANCHESTER_ALL=1 walks through everything that needs no server, else through the core of it.
export default defineConfig({
  ...config,
  outputDir: "test-results/web",
  grepInvert: /@server/,
  testIgnore: [],
  testMatch: process.env.LANCHESTER_ALL ? all : place.endsWith(".html") ? file : core,
});
