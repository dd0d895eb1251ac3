// How the page is built that answers by itself: with the module beside it, or with everything in one file.

import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { gzipSync } from "node:zlib";
import type { Plugin } from "vite";

/** Seen where scripts do not run: from a disk no browser loads what stands beside a page. */
const UNSEEN = `<p style="max-width: 40em; margin: 3em auto; font: 16px/1.5 sans-serif; opacity: 0; animation: said 0s 3s forwards">
        The studio does not start. From a disk open <a href="./lanchester.html">lanchester.html</a>, the page that is one file; this one needs a
        file server.
      </p>
      <style>@keyframes said { to { opacity: 1 } }</style>`;

/** Nothing comes from elsewhere, and nothing is sent anywhere; the module may be compiled. */
const POLICY = {
  folder:
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; " +
    "worker-src blob:; object-src 'none'; base-uri 'none'; form-action 'none'",
  file:
    "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src data: blob:; " +
    "worker-src blob:; base-uri 'none'; form-action 'none'",
};

/** The notices of third parties, which a page in one file carries along. */
const NOTICES = "../third-party.txt";

export function inBrowser(mode: string): Plugin {
  const file = mode === "web-file";
  return {
    name: "lanchester-in-browser",
    enforce: "pre",
    apply: (_, { command }) => command === "build" && mode.startsWith("web"),
    // Who answers: everything else of the page is the same.
    resolveId(source, importer) {
      return source === "./server" && importer?.endsWith("/src/api/client.ts")
        ? this.resolve("./worker/browser", importer)
        : null;
    },
    transformIndexHtml(html) {
      const rule = `<meta http-equiv="Content-Security-Policy" content="${file ? POLICY.file : POLICY.folder}" />`;
      const guarded = html.replace('<meta name="referrer"', `${rule}\n    <meta name="referrer"`);
      return file ? guarded : guarded.replace('<div id="app"></div>', `<div id="app">${UNSEEN}</div>`);
    },
    generateBundle: {
      order: "post",
      handler(_, bundle) {
        const path = process.env.LANCHESTER_MODULE;
        if (!path) throw new Error("LANCHESTER_MODULE names no module: `cargo xtask web` builds one");
        const module = readFileSync(resolve(path));
        if (!file) {
          this.emitFile({ type: "asset", fileName: "lanchester.wasm", source: module });
          return;
        }
        const page = bundle["index.html"];
        if (page?.type !== "asset") throw new Error("the page has no index.html");
        let html = String(page.source);
        for (const [name, part] of Object.entries(bundle)) {
          if (name === "index.html") continue;
          html = inlined(html, name, part.type === "chunk" ? part.code : String(part.source));
          delete bundle[name];
        }
        const packed = gzipSync(module, { level: 9 }).toString("base64");
        const notices = readFileSync(resolve(NOTICES), "utf8").replaceAll("</script", "<\\/script");
        const element =
          `<script type="text/plain" id="third-party">\n${notices}</script>\n` +
          `    <script type="application/gzip" id="lanchester-module">${packed}</script>`;
        // Before the page's script, which looks for it.
        html = html.replace('<div id="app">', () => `${element}\n    <div id="app">`);
        delete bundle["index.html"];
        this.emitFile({ type: "asset", fileName: "lanchester.html", source: html });
      },
    },
  };
}

/** The page with a script or a style in place of its address. */
function inlined(html: string, name: string, text: string): string {
  const style = name.endsWith(".css");
  const address = name.replaceAll(".", "\\.");
  const element = style
    ? new RegExp(`<link[^>]*href="\\./${address}"[^>]*>`)
    : new RegExp(`<script[^>]*src="\\./${address}"[^>]*></script>`);
  if (!element.test(html)) throw new Error(`the page does not name ${name}`);
  if (style) return html.replace(element, () => `<style>${text.replaceAll("</style", "<\\/style")}</style>`);
  // Scripts of modules run when the document is there, wherever they stand.
  const safe = text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
  return html.replace(element, () => `<script type="module">${safe}</script>`);
}
