// Built page in Chromium with a server of the test: functions answer its calls, and the test sends news. The security policy is that of the
// studio.

import {createReadStream, existsSync} from "node:fs";
import {createServer} from "node:http";
import {readFile} from "node:fs/promises";
import {extname, join, normalize} from "node:path";
import {newContext} from "./browser.mjs";

const types = {".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".json": "application/json"};
const policy = (nonce) =>
  `default-src 'none'; script-src 'self'; worker-src 'self'; connect-src 'self' ws:; img-src 'self' data: blob:; style-src 'self' 'nonce-${nonce}'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'`;

function serve(folder) {
  const server = createServer(async (request, response) => {
    const path = normalize(new URL(request.url, "http://x").pathname), file = join(folder, path === "/" ? "index.html" : path);
    if (!existsSync(file)) return response.writeHead(404).end();
    response.setHeader("Content-Type", types[extname(file)] ?? "application/octet-stream");
    if (path !== "/") return createReadStream(file).pipe(response);
    response.setHeader("Content-Security-Policy", policy("abc"));
    response.end((await readFile(file, "utf8")).replaceAll("STUDIO_NONCE", "abc"));
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

/** Returns a data frame of protocol 1 with all samples. */
function frameBytes({view, sequence = 1, run = 1, newest, time, columns}) {
  const all = [time, ...columns], bytes = Buffer.alloc(32 + 8 * time.length * all.length);
  bytes.write("SWD1", 0, "latin1");
  bytes.writeUInt8(1, 4);
  bytes.writeUInt16LE(view, 6);
  [sequence, time.length].forEach((value, i) => bytes.writeUInt32LE(value, 8 + 4 * i));
  bytes.writeUInt16LE(all.length, 16);
  bytes.writeUInt32LE(run, 20);
  bytes.writeDoubleLE(newest ?? time[time.length - 1], 24);
  all.flat().forEach((value, i) => bytes.writeDoubleLE(value, 32 + 8 * i));
  return bytes;
}

/** Default answers of the server. */
export const usual = {
  hello: () => ({version: "test", file: 0, loop: false}),
  files: () => ({files: [{file: 0, name: "test.yaml", writable: true, part: false}]}),
  open: () => ({name: "test.yaml", text: "stepwire: 1\n", hash: "0", draft: null, version: 0}),
  "state.get": () => ({state: {"tour.seen": true}}), "state.put": () => ({}), blocks: () => ({blocks: []}), language: () => ({}),
  graph: () => ({graph: {title: "", nodes: [], edges: []}, ranges: {}}), "data.want": () => ({}), clock: ({page}) => ({page, server: page}),
  "run.load": () => ({run: 1, step: 0.001, stop: 1, columns: [], parameters: [], scopes: [], inputs: [], scene: false, figures: 0, claims: []}),
  gallery: () => ({entries: []}), mechanism: () => ({mechanisms: []}), "run.play": () => ({}), scene: () => ({scene: null}), figures: () => ({figures: []}), claims: () => ({claims: []}),
};

/**
 * Opens the page. `answers` are functions from the arguments of a call to its result, or they throw; `view` has width, height, colorScheme,
 * touch. Returns {page, calls, news(message), faults(), close()}, with all received calls, and errors of the page.
 */
export async function openPage(folder, answers = {}, {width = 1400, height = 900, colorScheme = "light", hasTouch = false, reducedMotion = "no-preference"} = {}) {
  const server = await serve(folder), context = await newContext({viewport: {width, height}, colorScheme, hasTouch, reducedMotion});
  const page = await context.newPage(), all = {...usual, ...answers}, calls = [], errors = [];
  let socket, whether = () => true;
  page.on("pageerror", (error) => errors.push(error.stack ?? String(error)));
  page.on("console", (message) => { if (message.type() === "error") errors.push(message.text()); });
  await page.routeWebSocket("**/socket", (opened) => {
    if (!whether()) return opened.close();
    socket = opened;
    opened.onMessage((text) => {
      const {id, call, ...rest} = JSON.parse(text);
      if (call === undefined) return;
      calls.push({call, ...rest});
      if (id === undefined) return;
      try {
        if (!all[call]) throw new Error(`there is no call '${call}'`);
        Promise.resolve(all[call](rest)).then((result) => opened.send(JSON.stringify({id, result})));
      } catch (thrown) {
        opened.send(JSON.stringify({id, fault: {text: thrown.message, ...thrown}}));
      }
    });
  });
  const close = async () => {
    await context.close();
    server.close();
  };
  try {
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    await page.waitForSelector(".panes");
  } catch (thrown) {
    await close();
    throw thrown;
  }
  return {
    page, calls, errors, news: (message) => socket.send(JSON.stringify(message)),
    frame: (frame) => socket.send(frameBytes(frame)),
    /** Closes the connection like a server that ends; the page can connect again once `isBack` returns true. */
    cut: (isBack) => { whether = isBack; socket.close(); },
    close,
  };
}
