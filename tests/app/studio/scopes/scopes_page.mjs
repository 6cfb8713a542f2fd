// Test page of scopes, run bar and tuning in a browser, on a simulated server.

import assert from "node:assert/strict";
import {after, before} from "node:test";
import {missing, newContext} from "../browser.mjs";
import {served} from "./bundled.mjs";

export const options = {skip: missing};
let site;

before(async () => {
  if (!missing) site = await served();
});
after(() => site?.close());

/** Opens a page whose run has reached `until` [s] at this rate; 0: as fast as possible. */
export async function at(until, action, {query = "", rate = 5, ...more} = {}) {
  const context = await newContext({viewport: {width: 1200, height: 800}, acceptDownloads: true, permissions: ["clipboard-read", "clipboard-write"], ...more});
  const page = await context.newPage(), errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  try {
    await page.goto(`${site.address}?${query}`);
    await page.waitForFunction(() => window.studio?.board.scopes.length > 0);
    if (until > 0) await run(page, until, rate);
    await action(page);
    assert.deepEqual(errors, []);
  } finally {
    await context.close();
  }
}

export async function run(page, until, rate = 5) {
  await page.evaluate((one) => studio.context.run.play(one), rate);
  await page.waitForFunction((time) => studio.context.run.news.time >= time, until);
  await page.evaluate(() => studio.context.run.pause());
  await page.waitForFunction((time) => studio.context.run.news.state === "paused" && studio.board.scopes[0].feed.frame?.newest >= time, until);
  await settled(page);
}

/** Waits until the requested data are drawn. */
export async function settled(page) {
  await page.waitForFunction(() => studio.board.scopes.every(({feed, traces}) => traces.length === 0 || (feed.frame && !feed.isOld)));
  await page.evaluate(() => new Promise((done) => { let left = 5; const next = () => (left-- > 0 ? requestAnimationFrame(next) : done()); next(); }));
}

export const over = (page, scope = 0) => page.locator(".scope").nth(scope).locator(".u-over");
export const menu = async (page, scope, entry) => {
  await page.locator(".scope").nth(scope).getByRole("button", {name: "Menu of"}).click();
  await page.getByRole("menuitem", {name: entry}).click();
};
export const state = (page) => page.locator(".scope-bar .chip").first().textContent();
