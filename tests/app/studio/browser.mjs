// One browser for all pages of a test file, since its start takes longer than most tests, and the timeout of waits.

import assert from "node:assert/strict";
import {existsSync} from "node:fs";

const playwright = await import("playwright-core").then((all) => all.default ?? all, () => undefined);
const executablePath = [process.env.STEPWIRE_CHROMIUM, "/usr/bin/chromium"].find((path) => path && existsSync(path));

/** Reason why there is no browser; false if there is one. */
export const missing = !playwright ? "playwright-core is not installed: ./stepwire setup tests"
  : !executablePath ? "chromium is not installed; on Debian it is the package chromium" : false;

/** Timeout for actions that are immediate on an idle machine [ms]. */
const patience = 60_000;
/** Delay after the last context before the browser ends, so that the next test can reuse it [ms]. */
const linger = 200;
let shared, users = 0;

function leave() {
  --users;
  setTimeout(() => {
    if (users > 0 || !shared) return;
    shared.then((browser) => browser.close(), () => {});
    shared = undefined;
  }, linger);
}

/** Creates an isolated context whose pages use the long timeout. */
export async function newContext(options) {
  ++users;
  try {
    shared ??= playwright.chromium.launch({executablePath, args: ["--no-sandbox", "--disable-gpu"]});
    const context = await (await shared).newContext(options);
    context.setDefaultTimeout(patience);
    context.once("close", leave);
    return context;
  } catch (thrown) {
    leave();
    throw thrown;
  }
}

/** Waits until a condition holds; fails with its description after the timeout. */
export async function until(holds, what = String(holds)) {
  for (const end = Date.now() + patience; !await holds();) {
    if (Date.now() > end) assert.fail(what);
    await new Promise((done) => setTimeout(done, 25));
  }
}
