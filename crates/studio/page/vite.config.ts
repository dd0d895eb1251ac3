import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vitest/config";
import { book } from "./book";
import { inBrowser } from "./web";

// The server that `npm run dev` talks to: `lanchester studio --port 7777 --token dev`.
const server = process.env.LANCHESTER_SERVER ?? "http://127.0.0.1:7777";

// Mode "web": a folder for any file server; "web-file": one file. Both answer by themselves, with the module that LANCHESTER_MODULE names.
export default defineConfig(({ mode }) => ({
  plugins: [svelte(), book(), inBrowser(mode)],
  base: "./",
  build: {
    outDir: "../dist",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1200,
    rolldownOptions: {
      output: {
        // Names without hashes: the built page stands in the repository, and its history stays readable.
        entryFileNames: "assets/[name].js",
        chunkFileNames: "assets/[name].js",
        assetFileNames: "assets/[name][extname]",
        ...(mode === "web-file" ? { codeSplitting: false } : {}),
      },
    },
  },
  server: {
    port: Number(process.env.PORT ?? 5173),
    proxy: { "/api": { target: server, changeOrigin: true, headers: { origin: server } } },
  },
  test: { environment: "happy-dom", include: ["src/**/*.test.ts"] },
  resolve: process.env.VITEST ? { conditions: ["browser"] } : {},
}));
