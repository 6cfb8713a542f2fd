// The page of scopes, run bar and tuning in a browser, on a run that is made up.

import assert from "node:assert/strict";
import {existsSync} from "node:fs";
import {after, before} from "node:test";
import {served} from "./bundled.mjs";

const playwright = await import("playwright-core").then((all) => all.default ?? all, () => undefined);
const executablePath = [process.env.STEPWIRE_CHROMIUM, "/usr/bin/chromium"].find((path) => path && existsSync(path));
const skip = !playwright ? "playwright-core is not installed: npm ci in tests/app/studio" : !executablePath ? "chromium is not installed" : false;
export const options = {skip, timeout: 120_000};
let browser, site;

before(async () => {
  if (skip) return;
  site = await served();
  browser = await playwright.chromium.launch({executablePath, args: ["--no-sandbox", "--disable-gpu"]});
});
after(async () => {
  await browser?.close();
  site?.close();
});

/** A page whose run stands at `until` [s]. */
export async function at(until, action, {query = "", ...more} = {}) {
  const context = await browser.newContext({viewport: {width: 1200, height: 800}, acceptDownloads: true, permissions: ["clipboard-read", "clipboard-write"], ...more});
  const page = await context.newPage(), errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  try {
    await page.goto(`${site.address}?${query}`);
    await page.waitForFunction(() => window.studio?.board.scopes.length > 0);
    if (until > 0) await run(page, until);
    await action(page);
    assert.deepEqual(errors, []);
  } finally {
    await context.close();
  }
}

export async function run(page, until) {
  await page.evaluate(() => studio.context.run.play(5));
  await page.waitForFunction((time) => studio.context.run.news.time >= time, until);
  await page.evaluate(() => studio.context.run.pause());
  await page.waitForFunction((time) => studio.context.run.news.state === "paused" && studio.board.scopes[0].feed.frame?.newest >= time, until);
  await settled(page);
}

/** Waits until what was asked for has come and was drawn. */
export async function settled(page) {
  await page.waitForFunction(() => studio.board.scopes.every(({feed, traces}) => traces.length === 0 || (feed.frame && !feed.isOld)));
  await page.evaluate(() => new Promise((done) => { let left = 5; const next = () => (left-- > 0 ? requestAnimationFrame(next) : done()); next(); }));
}

export const over = (page, scope = 0) => page.locator(".scope").nth(scope).locator(".u-over");
export const menu = async (page, scope, entry) => {
  await page.locator(".scope").nth(scope).getByRole("button", {name: "What may be done"}).click();
  await page.getByRole("menuitem", {name: entry}).click();
};
export const state = (page) => page.locator(".scope-bar .chip").first().textContent();
