// Studio as a user starts it: the program on a copy of a diagram, and a browser with its page.

import {execFileSync, spawn} from "node:child_process";
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {extname, join} from "node:path";
import * as browser from "./browser.mjs";

const program = process.env.STEPWIRE_PROGRAM;

/** Reason why no page can be tested here; false if one can. */
export const missing = !program ? "STEPWIRE_PROGRAM names the program"
  : browser.missing ? browser.missing
  : process.env.STUDIO_PAGE && !existsSync(join(process.env.STUDIO_PAGE, "index.html")) ? "the page is not built: npm is missing"
  : false;

/** Resolves to the address that the program prints. */
function addressOf(server) {
  return new Promise((resolve, reject) => {
    let printed = "";
    server.stdout.on("data", (piece) => {
      printed += piece;
      const address = /http:\/\/127\.0\.0\.1:\d+\/\?token=\w+/.exec(printed);
      if (address) resolve(address[0]);
    });
    server.stderr.on("data", (piece) => { printed += piece; });
    server.on("exit", (code) => reject(new Error(`the studio ended with ${code}: ${printed}`)));
  });
}

/** Folder with one diagram file, the studio that serves it, and its page. */
export class Studio {
  errors = [];

  /** Opens a diagram with this text, in a folder of its own. */
  static async opened(text, {name = "diagram.yaml", ...options} = {}) {
    const studio = new Studio();
    studio.folder = mkdtempSync(join(tmpdir(), "studio-"));
    studio.path = join(studio.folder, name);
    writeFileSync(studio.path, text);
    return studio.seen(options);
  }

  /** Opens an existing file in place; the test must not save it. */
  static async on(path, options = {}) {
    const studio = new Studio();
    studio.folder = mkdtempSync(join(tmpdir(), "studio-"));
    studio.path = path;
    return studio.seen(options);
  }

  /**
   * Starts the studio and its page. The folder also has the user's state, so that the test does not read that of its user. `seen` runs in
   * the page first.
   */
  async seen({width = 1400, height = 900, colorScheme = "light", seen, more = []} = {}) {
    this.context = browser.newContext({viewport: {width, height}, colorScheme});
    try {
      await this.start(more);
      const context = await this.context;
      if (seen) await context.addInitScript(seen);
      this.page = await this.visit(context);
      return this;
    } catch (thrown) {
      await this.close();
      throw thrown;
    }
  }

  async start(more = []) {
    const environment = {...process.env, XDG_STATE_HOME: join(this.folder, "state"), XDG_CACHE_HOME: join(this.folder, "cache")};
    this.server = spawn(program, ["studio", "--no-open", ...more, this.path], {env: environment});
    this.address = await addressOf(this.server);
  }

  /** Opens another page on the same file. */
  async visit(context) {
    const page = await context.newPage();
    // Uses a page that was just built, before it is compiled into the program.
    if (process.env.STUDIO_ASSETS) await context.route(/\/assets\//, async (route) => {
      const path = join(process.env.STUDIO_ASSETS, new URL(route.request().url()).pathname), types = {".js": "text/javascript", ".css": "text/css"};
      return existsSync(path) ? route.fulfill({path, headers: {"Content-Type": types[extname(path)] ?? "image/svg+xml", "Cross-Origin-Embedder-Policy": "require-corp", "Cross-Origin-Resource-Policy": "same-origin"}}) : route.continue();
    });
    page.on("pageerror", (error) => this.errors.push(error.stack ?? String(error)));
    page.on("console", (message) => { if (message.type() === "error") this.errors.push(message.text()); });
    await page.goto(this.address);
    await page.waitForSelector(page.viewportSize().width < 720 ? ".run-time" : ".cm-content");  // a narrow page shows one pane
    return page;
  }

  get file() {
    return readFileSync(this.path, "utf8");
  }

  /** Runs the file by `run`; returns the rows of its signals as numbers, by name. */
  run() {
    const out = join(this.folder, "out");
    execFileSync(program, ["run", this.path, "--out", out], {stdio: "pipe"});
    const [names, ...rows] = readFileSync(join(out, "signals.csv"), "utf8").trim().split("\n").filter((line) => !line.startsWith("#")).map((line) => line.split(","));
    return Object.fromEntries(names.map((name, i) => [name.replace(/ *[[(].*/, ""), rows.map((row) => Number(row[i]))]));
  }

  async close() {
    await this.context?.then((context) => context.close(), () => {});
    const {server} = this;
    server?.removeAllListeners("exit");
    if (server && server.exitCode === null && server.signalCode === null) {
      server.kill();
      await new Promise((ended) => server.once("exit", ended));  // until then it may write into the folder
    }
    rmSync(this.folder, {recursive: true, force: true});
  }
}

/** Returns the exact samples of columns of the run, by a second connection beside the page's own. */
export function samplesOf(page, names) {
  return page.evaluate(async (wanted) => {
    const socket = new WebSocket(`ws://${location.host}/socket`);
    socket.binaryType = "arraybuffer";
    await new Promise((resolve) => { socket.onopen = resolve; });
    const call = (id, request) => new Promise((resolve) => {
      const listener = ({data}) => {
        if (typeof data !== "string" || JSON.parse(data).id !== id) return;
        socket.removeEventListener("message", listener);
        resolve(JSON.parse(data).result);
      };
      socket.addEventListener("message", listener);
      socket.send(JSON.stringify({id, ...request}));
    });
    await call(1, {call: "hello", protocol: 1});
    const columns = [];
    for (const [i, expression] of wanted.entries()) columns.push((await call(2 + i, {call: "scope.signal", expression})).column);
    const frame = new Promise((resolve) => socket.addEventListener("message", ({data}) => { if (typeof data !== "string") resolve(data); }));
    await call(100, {call: "data.want", views: [{view: 60000, columns, from: 0, to: 1e9, follow: null, pixels: 1000000}]});
    const bytes = await frame, head = new DataView(bytes), rows = head.getUint32(12, true);
    socket.close();
    return {kind: head.getUint8(5), columns: ["time", ...wanted].map((name, i) => [name, [...new Float64Array(bytes, 32 + 8 * rows * i, rows)]])};
  }, names);
}
