// A small gallery, and a browser that opens its files directly, as their author does.

import {spawnSync} from "node:child_process";
import {existsSync, mkdtempSync, readdirSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {pathToFileURL} from "node:url";

const playwright = await import("playwright-core").then((all) => all.default ?? all, () => undefined);
const chromium = [process.env.STEPWIRE_CHROMIUM, "/usr/bin/chromium"].find((path) => path && existsSync(path));

/** Why there is no browser here; false where there is one. */
export const missing = !playwright ? "playwright-core is not installed: ./stepwire setup tests"
  : !chromium ? "chromium is not installed; on Debian it is the package chromium"
  : false;

export const only = ["fig15", "fig17", "fig38", "table1"];

/** Every way in which a page may be met. */
export const ways = [1400, 400].flatMap((width) => ["light", "dark"].flatMap((colorScheme) =>
  [true, false].map((script) => ({width, colorScheme, script}))));
export const nameOf = ({width, colorScheme, script}) => `${width} px, ${colorScheme}, ${script ? "with" : "without"} script`;

export class Gallery {
  static async made() {
    const gallery = new Gallery();
    gallery.folder = mkdtempSync(join(tmpdir(), "gallery-"));
    const {status, stdout, stderr} = spawnSync(process.env.STEPWIRE_PROGRAM, ["thesis", "--only", only.join(","), "--out", gallery.folder]);
    if (status !== 0) throw new Error(String(stderr));
    gallery.said = String(stdout);
    gallery.browser = await playwright.chromium.launch({executablePath: chromium, args: ["--no-sandbox", "--disable-gpu"]});
    return gallery;
  }

  async gone() {
    await this.browser.close();
    rmSync(this.folder, {recursive: true});
  }

  url(page) {
    return pathToFileURL(join(this.folder, page)).href;
  }

  /** The pages, as paths in the gallery. */
  pages() {
    const under = (folder) => readdirSync(join(this.folder, folder), {withFileTypes: true}).flatMap((entry) =>
      entry.isDirectory() ? under(join(folder, entry.name)) : entry.name.endsWith(".html") ? [join(folder, entry.name)] : []);
    return under("");
  }
  /** The same, but one for all that show parts. */
  kinds() {
    const parts = this.pages().filter((page) => page.startsWith("diagrams/parts/"));
    return this.pages().filter((page) => !parts.slice(1).includes(page));
  }
  entries() {
    return this.pages().filter((page) => /^(fig|table)/.test(page)).map((page) => page.split("/")[0]);
  }

  /** Opens pages in one way, does something with them, and closes them. */
  async with({width = 1400, colorScheme = "light", script = true}, action) {
    const context = await this.browser.newContext({viewport: {width, height: 900}, colorScheme, javaScriptEnabled: script, acceptDownloads: true});
    try {
      const page = await context.newPage();
      return await action(page);
    } finally {
      await context.close();
    }
  }
}
