// View of a real-time loop in Chromium, with invented data of the server.

import assert from "node:assert/strict";
import {test} from "node:test";
import {until} from "./browser.mjs";
import {openPage} from "./scene_page.mjs";
import {built, skip} from "./two_blocks.mjs";

/** Returns bins of a quarter octave around a time. */
function histogram(middle, counts) {
  const edges = Array.from({length: counts.length + 1}, (_, i) => middle * 2 ** ((i - 2) / 4)), count = counts.reduce((sum, one) => sum + one, 0);
  return {count, p50: middle, p99: 2 * middle, p999: 4 * middle, max: edges[edges.length - 1], edges, counts};
}
const timing = (more = {}) => ({
  run: 1, period: 1e-3, served: 20000, missed: 0, late: 0, dropped: 0, longest: 0, lateness: histogram(20e-6, [9, 900, 18000, 1000, 80, 9, 2]),
  response: histogram(90e-6, [10, 1900, 17000, 1000, 80, 9, 1]), step: histogram(120e-6, [10, 1900, 17000, 1000, 80, 9, 1]),
  costs: [{type: "MRDamper", blocks: 2, mean: 31e-6}, {type: "Gain", blocks: 1, mean: 0.4e-6}], lost: 0, policy: "fifo:80", refused: ["the system did not lock the memory"], ...more,
});
const answers = (loop) => ({
  hello: () => ({version: "test", file: 0, loop: true}), loop,
  "run.load": () => ({run: 1, step: 0.001, stop: null, columns: [], parameters: [], scopes: [], inputs: [], scene: false, figures: 0, claims: [], loop: {rate: 1000, period: 1e-3, policy: "fifo:80", overrun: "drop"}}),
});

async function withLoop(loop, action, options) {
  const opened = await openPage(built, answers(loop), options);
  try {
    await action(opened);
    assert.deepEqual(opened.errors, []);
  } finally {
    await opened.close();
  }
}

test("a loop is in front: its deadlines, times and costs, in numbers and as a picture with a description", {skip}, () => withLoop(() => timing(), async ({page}) => {
  await page.getByText("Every deadline was kept.").waitFor();
  assert.equal(await page.getByRole("tab", {name: "Loop"}).getAttribute("aria-selected"), "true");
  const facts = await page.locator(".loop-facts").textContent();
  for (const fact of ["period 1 ms", "policy fifo:80", "served 20,000"]) assert.ok(facts.includes(fact), facts);
  await page.getByText("the system did not lock the memory").waitFor();
  const rows = await page.locator(".loop-times tbody tr").allTextContents();
  assert.match(rows[0], /^lateness20 µs40 µs80 µs/);
  assert.match((await page.locator(".loop-costs tbody tr").allTextContents())[0], /^MRDamper231 µs 3\.1 % of the period/);
  assert.match(await page.locator(".loop-chart").getAttribute("aria-label"), /lateness: median 20 µs, 99 % below 40 µs/);
  const line = await page.locator(".loop-deadline").boundingBox(), bars = await page.locator("path.loop-response").boundingBox();
  assert.ok(bars.x + bars.width < line.x, "what is done in time lies left of the deadline");
  for (const one of [".run-buttons select", ".scrub", "[aria-label='One tick']"]) assert.equal(await page.locator(one).isVisible(), false, one);
}));

test("misses are shown and announced as they come", {skip}, () => {
  let now = timing();
  return withLoop(() => now, async ({page, news}) => {
    await page.getByText("Every deadline was kept.").waitFor();
    now = timing({missed: 7, late: 5, dropped: 2, longest: 3, response: histogram(900e-6, [10, 1900, 17000, 1000, 80, 9, 5])});
    news({news: "loop", ...now});
    await page.getByText("7 of 20,002 deadlines were missed.").waitFor();
    assert.ok(await page.locator(".loop-verdict").evaluate((one) => one.classList.contains("loop-missed")));
    const line = await page.locator(".loop-deadline").boundingBox(), bars = await page.locator("path.loop-response").boundingBox();
    assert.ok(bars.x + bars.width > line.x);
  });
});

test("a studio without a loop has no such pane, and a loop that has not begun says so", {skip}, async () => {
  await withLoop(() => timing({served: 0, costs: [], lateness: histogram(1e-6, []), response: histogram(1e-6, []), step: histogram(1e-6, [])}), async ({page}) => {
    await page.getByText("The loop has not started; Play starts it.").waitFor();
  }, {width: 400, height: 800});
  const {page, close} = await openPage(built, {});
  try {
    assert.equal(await page.getByRole("tab", {name: "Loop"}).count(), 0);
  } finally {
    await close();
  }
});

test("who watches the file's own hand loads the run so, and is the hand again by the same button", {skip}, async () => {
  const loads = [], load = (wanted) => { loads.push(wanted.hand); return {run: 1, step: 0.001, stop: 1, columns: [], parameters: [], scopes: [], inputs: [], scene: true, figures: 0, claims: []}; };
  const scene = () => ({scene: {x: [0, 0.1], y: [0, 0.1], background: "#101820", objects: [], pointer: {name: "pointer", held: "pointer_held", text: "", hand: loads.at(-1)}}});
  const {page, errors, close} = await openPage(built, {"run.load": load, scene, "scene.watch": () => ({})});
  try {
    await page.getByRole("tab", {name: "Scene"}).click();
    const button = page.getByRole("button", {name: "Hand of the file"});
    await button.click();
    await page.getByText("The hand of the file moves it; you only watch.").waitFor();
    assert.equal(await button.getAttribute("aria-pressed"), "true");
    await button.click();
    await until(() => loads.at(-1) === true && loads.length > 2);
    await page.getByText("Press and move over the scene").waitFor();
    assert.deepEqual(errors, []);
  } finally {
    await close();
  }
});
