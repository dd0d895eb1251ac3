// The module: beside the page as a file, or within the page where it is one file.

/** The element of a page that is one file: the module, compressed, as base64. */
const INLINE = "lanchester-module";
const FILE = "./lanchester.wasm";

export async function loadModule(): Promise<WebAssembly.Module> {
  const inline = document.getElementById(INLINE);
  if (inline) return WebAssembly.compile(await unpacked(inline.textContent ?? ""));
  const response = await fetch(new URL(FILE, document.baseURI));
  if (!response.ok) throw new Error(`${FILE}: status ${response.status}`);
  // Some servers do not know the media type, which compiling while loading asks for.
  if (response.headers.get("Content-Type")?.startsWith("application/wasm"))
    return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

async function unpacked(base64: string): Promise<ArrayBuffer> {
  const binary = atob(base64.trim());
  const bytes = new Uint8Array(binary.length);
  for (let at = 0; at < binary.length; at++) bytes[at] = binary.charCodeAt(at);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}
