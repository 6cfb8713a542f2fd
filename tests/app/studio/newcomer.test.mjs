// First ten minutes of a new user: opening a diagram with a fault, its quick fix, connecting two blocks, and a run. Then the user reads a
// value at the cursor, moves a slider, writes the value to the text and saves. `run` of the saved file gives the same values, bit by bit.

import assert from "node:assert/strict";
import {test} from "node:test";
import {missing, samplesOf, Studio} from "./studio.mjs";

const text = `stepwire: 1
title: A lag and a gain
step: 1 ms
stop: 2 s
solver: rk4
blocks:
  command: {block: Constant, value: 2}
  lag:     {block: Lag, u: comand, tau: 0.4 s}
  twice:   {block: Gain, u: command, gain: 2}
record: [lag, twice]
claims:
  - {that: it comes to rest, at: {time: 2 s, value: twice}, equals: 4, within: 0.2}
`;

const textHas = (page, part) => page.waitForFunction((one) => document.querySelector(".cm-content").textContent.includes(one), part);
const shape = (page, id) => page.locator(`[data-shape="${id}"]`);

/** Opens the file, checks that its fault is marked, and applies the quick fix by keys. */
async function mend(page) {
  await page.getByRole("button", {name: "Dismiss"}).click();
  await page.waitForSelector(".cm-lintRange-error");
  assert.match(await page.locator(".drawing-fault").textContent(), /no block 'comand'; did you mean 'command'/);
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+Home");
  await page.waitForFunction(() => document.querySelector(".cm-lintRange-error"));
  await page.keyboard.press("Control+.");
  await textHas(page, "u: command, tau");
  await shape(page, "lag").waitFor();
  await page.waitForSelector(".drawing-fault", {state: "hidden"});
}

/** Draws a wire from the lag to the gain, whose source was the command. */
async function connect(page) {
  await shape(page, "lag").hover();
  const from = await shape(page, "lag").locator(".port-output").boundingBox(), to = await shape(page, "twice").locator(".port-input").boundingBox();
  await page.mouse.move(from.x + from.width / 2, from.y + from.height / 2);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, {steps: 3});
  await page.waitForSelector("[data-shape='twice'].fits");
  await page.mouse.move(to.x + to.width / 2, to.y + to.height / 2, {steps: 3});
  await page.mouse.up();
  await textHas(page, "twice:   {block: Gain, u: lag, gain: 2}");
  await page.waitForFunction(() => [...document.querySelectorAll("[role=option]")].some((one) => one.getAttribute("aria-label") === "twice, Gain; from lag"));
}

/** Runs to the end, as fast as possible. */
async function run(page) {
  await page.getByLabel(/^Speed/).selectOption({value: "0"});
  await page.getByRole("button", {name: "Restart"}).click();
  await page.getByRole("button", {name: "Play"}).click();
  await page.waitForFunction(() => document.querySelector(".run-time").textContent.startsWith("2.000"));
  await page.waitForSelector(".scope canvas");
}

/** Places a cursor in the scope by keys; screen readers get its value as text. */
async function look(page) {
  const scope = page.locator(".scope").first();
  await scope.focus();
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction(() => [...document.querySelectorAll("[aria-live], [role=status]")].some((one) => /lag/.test(one.textContent) && /\d/.test(one.textContent)));
}

/** Sets another time constant while the run is paused, then writes it to the text. */
async function tune(page) {
  const field = page.getByLabel(/^lag\.tau, /).and(page.locator("input[type=text]"));
  await field.fill("0.2 s");
  await field.press("Enter");
  await page.getByRole("button", {name: /^Write this value to the text.*: lag\.tau$/}).click();
  await textHas(page, "tau: 0.2 s");
}

async function save(page) {
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+s");
  await page.waitForFunction(() => document.querySelector(".bar-file button").disabled);
}

test("a newcomer mends, connects, runs, looks, tunes and saves, and the file gives the bits that were seen", {skip: missing}, async () => {
  const studio = await Studio.opened(text), {page} = studio;
  try {
    await mend(page);
    await connect(page);
    await run(page);
    await look(page);
    await tune(page);
    await save(page);
    assert.equal(studio.file, text.replace("comand", "command").replace("u: command, gain", "u: lag, gain").replace("0.4 s", "0.2 s"));
    await run(page);
    const seen = await samplesOf(page, ["lag", "twice"]), made = studio.run();
    assert.equal(seen.kind, 0);
    for (const [name, values] of seen.columns) assert.deepEqual(values, made[name], name);
    assert.equal(seen.columns[0][1].length, 2001);
    assert.deepEqual(studio.errors, []);
  } finally {
    await studio.close();
  }
});
