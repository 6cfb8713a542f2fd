// Bundles of page modules for node, and of the test page of scopes for a browser; esbuild is a dependency of the page's build.

import {copyFileSync, mkdtempSync} from "node:fs";
import {createServer} from "node:http";
import {readFile} from "node:fs/promises";
import {createRequire} from "node:module";
import {tmpdir} from "node:os";
import {dirname, extname, join, resolve} from "node:path";
import {fileURLToPath, pathToFileURL} from "node:url";

const here = dirname(fileURLToPath(import.meta.url)), page = resolve(here, "../../../../engine/app/studio/page");
const esbuild = createRequire(join(page, "package.json"))("esbuild");
const usual = {bundle: true, format: "esm", target: "es2022", logLevel: "error", absWorkingDir: page, nodePaths: [join(page, "node_modules")]};

/** Returns the exports of several modules of engine/app/studio/page/src. */
export async function bundled(...paths) {
  const contents = paths.map((path) => `export * from "./src/${path}";`).join("\n"), outfile = join(mkdtempSync(join(tmpdir(), "scopes-")), "modules.mjs");
  await esbuild.build({...usual, stdin: {contents, resolveDir: page}, outfile, platform: "node", loader: {".css": "empty"}});
  return import(pathToFileURL(outfile).href);
}

const types = {".html": "text/html", ".js": "text/javascript", ".css": "text/css"};

/** Serves the test page of scopes on a free port of this machine. */
export async function served() {
  const folder = mkdtempSync(join(tmpdir(), "scopes-page-"));
  await esbuild.build({...usual, entryPoints: [join(here, "page.ts"), join(here, "fake_worker.ts")], outdir: folder});
  copyFileSync(join(here, "page.html"), join(folder, "page.html"));
  const server = createServer(async ({url}, response) => {
    const name = new URL(url, "http://localhost").pathname.slice(1);
    const text = ["page.html", "page.js", "page.css", "fake_worker.js"].includes(name) ? await readFile(join(folder, name)) : undefined;
    response.writeHead(text ? 200 : 404, {"content-type": types[extname(name)] ?? "text/plain"}).end(text);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return {address: `http://127.0.0.1:${server.address().port}/page.html`, close: () => server.close()};
}
