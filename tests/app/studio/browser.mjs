// One browser for all pages of a test file, since to start one takes longer than most tests; and when a wait is given up.

import assert from "node:assert/strict";
import {existsSync} from "node:fs";

const playwright = await import("playwright-core").then((all) => all.default ?? all, () => undefined);
const executablePath = [process.env.STEPWIRE_CHROMIUM, "/usr/bin/chromium"].find((path) => path && existsSync(path));

/** Why there is no browser; false where there is one. */
export const missing = !playwright ? "playwright-core is not installed: ./stepwire setup tests"
  : !executablePath ? "chromium is not installed; on Debian it is the package chromium" : false;

/** How long something may take that comes at once on a machine with nothing else to do [ms]. */
const patience = 60_000;
/** The browser ends so long after its last context, so that the next test finds it running [ms]. */
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

/** A context with nothing of the others in it; its pages wait with patience. */
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

/** Waits until something holds, and says what does not. */
export async function until(holds, what = String(holds)) {
  for (const end = Date.now() + patience; !await holds();) {
    if (Date.now() > end) assert.fail(what);
    await new Promise((done) => setTimeout(done, 25));
  }
}
