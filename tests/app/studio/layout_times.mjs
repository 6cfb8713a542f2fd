// Measures in Chromium, on the program's own page, the time from a key press in a text of 100 blocks to the new drawing. It also measures
// the time for which the page is blocked. Prints lines of JSON with the goals; bench/studio formats them as a table.
// node layout_times.mjs [--edits 12] [--settle 12] [--short]; --settle: seconds until the search for the best layout ends

import {Studio} from "./studio.mjs";
import {given, print, printQuantiles, quantile} from "./times.mjs";

const {edits, settle} = given({edits: [12, 6], settle: [12, 1]});
const warmUp = 2;

/** Returns 100 blocks, each with one or two earlier blocks as sources. */
function hundredBlocks() {
  let seed = 1;
  const below = (limit) => Math.floor(((seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648) * limit);
  const block = (i) => {
    const near = Math.max(0, i - 1 - below(6)), any = below(i);
    return i % 5 === 0 ? `{block: Sum, u: [b${near}, b${any}]}` : i % 3 === 0 ? `{block: Lag, u: b${near}, tau: 0.1 s}` : `{block: Gain, gain: 2, u: b${near}}`;
  };
  const lines = Array.from({length: 99}, (_, i) => `  b${i + 1}: ${block(i + 1)}\n`);
  return `stepwire: 1\ntitle: many\nstep: 1 ms\nstop: 1 s\nsolver: rk4\nrecord: [b9]\nblocks:\n  b0: {block: Sine, amplitude: 1, frequency: 1 Hz}\n${lines.join("")}`;
}

/** In the page: records long tasks, and the time of the next drawing. */
function observe() {
  window.seen = {long: [], drawn: 0};
  new PerformanceObserver((list) => { for (const {duration} of list.getEntries()) window.seen.long.push(duration); }).observe({entryTypes: ["longtask"]});
  const watch = setInterval(() => {
    const picture = document.querySelector(".picture");
    if (!picture) return;
    clearInterval(watch);
    new MutationObserver(() => { window.seen.drawn = performance.now(); }).observe(picture, {childList: true, subtree: true});
  }, 20);
}

/**
 * Types a line at the end of the text. Resolves to the time from its last key to the drawing of the block [ms]; long tasks are recorded for
 * the whole line.
 */
async function typed(page, line, name) {
  await page.evaluate(() => { window.seen.long.length = 0; });
  await page.keyboard.press("Control+End");
  await page.keyboard.insertText(line.slice(0, -1));
  await page.waitForTimeout(1500);
  const before = await page.evaluate(() => performance.now());
  await page.keyboard.insertText(line.slice(-1));
  await page.waitForFunction((one) => document.querySelector(`[data-shape="${one}"]`), name, {polling: 5});
  await page.keyboard.insertText("\n");
  return await page.evaluate(() => window.seen.drawn) - before;
}

const studio = await Studio.opened(hundredBlocks(), {seen: observe}), times = [], longest = [];
try {
  const {page} = studio;
  await page.waitForSelector("[data-shape='b99']");
  await page.getByRole("button", {name: "Dismiss"}).click();
  await page.waitForTimeout(1000 * settle);
  await page.locator(".cm-content").focus();
  for (let i = 0; i < warmUp + edits; ++i) {
    const time = await typed(page, `  n${i}: {block: Gain, gain: 2, u: b${(37 * i) % 100}}`, `n${i}`);
    if (i < warmUp) continue;
    times.push(time);
    longest.push(await page.evaluate(() => Math.max(0, ...window.seen.long)));
  }
} finally {
  await studio.close();
}
const workload = "a block is typed into a diagram of 100";
printQuantiles(workload, "key to drawing", "ms", times, 300);
print(workload, "page does not answer, most of an edit, p50", "ms", quantile(longest, 0.5), 50);
print(workload, "page does not answer, at most", "ms", Math.max(...longest), 50, true);
