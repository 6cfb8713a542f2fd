// Bode plot of the running loop: requested at a wire of the drawing, written as two lines of text, and redrawn when a slider moves.

import assert from "node:assert/strict";
import {test} from "node:test";
import {until} from "./browser.mjs";
import {missing, Studio} from "./studio.mjs";

const text = `stepwire: 1
title: a loop
step: 1 ms
stop: 2 s
solver: rk4
parameters:
  gain: {value: 2, at_least: 1, at_most: 100}
blocks:
  command: {block: Constant, value: 1}
  error: {block: Sum, signs: "+-", u: [command, plant]}
  control: {block: Gain, gain: $gain, u: error}
  first: {block: Lag, u: control, tau: 0.1 s}
  second: {block: Lag, u: first, tau: 0.05 s}
  plant: {block: Lag, u: second, tau: 0.02 s}
record: [plant]
`;
/** The same diagram with an existing analysis, in another YAML style. */
const taken = text.replace("record:", "linear:   # of the loop\n     loop: {from: error, to: plant}\nfigure: {plot: lines, x: time, y: plant}\nrecord:");
/** The loop K / ((0.1 s + 1)(0.05 s + 1)(0.02 s + 1)) reaches the stability limit at K = 12.6, by Routh. */
const border = (0.1 + 0.05 + 0.02) * (1 / 0.1 + 1 / 0.05 + 1 / 0.02) - 1;
const margin = (page) => page.locator(".figure svg text").evaluateAll((all) => all.map((one) => parseFloat(one.textContent.replace("−", "-"))).find((_, i) => / dB$/.test(all[i].textContent)));

test("the loop is cut at a wire, its margins are seen, and follow the gain", {skip: missing}, async () => {
  const studio = await Studio.opened(text), {page} = studio;
  try {
    await page.getByRole("button", {name: "Dismiss"}).click();
    await page.locator("[data-shape='control']").click();
    await page.keyboard.press("w");
    await page.keyboard.press("b");
    await page.getByText("is added to the text").first().waitFor();
    await page.waitForFunction(() => /linear:\s*loop: \{from: (error|control)\.y, to: \1\.y, open: \1\.y\}figure:\s*- \{plot: bode, of: loop, title: The loop opened at \1\.y\}/.test(document.querySelector(".cm-content").textContent));
    assert.equal(await page.locator(".cm-scroller").evaluate((scroller) => scroller.scrollLeft), 0);
    await page.getByRole("button", {name: "Restart"}).click();
    await page.waitForFunction(() => [...document.querySelectorAll(".figure svg text")].some((one) => / dB$/.test(one.textContent)));
    assert.ok(Math.abs(await margin(page) - 20 * Math.log10(border / 2)) < 0.2, `${await margin(page)} dB`);
    const field = page.getByRole("textbox", {name: /^gain/});
    await field.fill("8");
    await field.press("Enter");
    await until(async () => Math.abs(await margin(page) - 20 * Math.log10(border / 8)) < 0.2, "the margin at a gain of 8");
    assert.deepEqual(studio.errors, []);
  } finally {
    await studio.close();
  }
});

test("a second loop is added to the analyses that there are, and the file loads", {skip: missing}, async () => {
  const studio = await Studio.opened(taken), {page} = studio;
  try {
    await page.getByRole("button", {name: "Dismiss"}).click();
    for (const block of ["control", "plant"]) {
      await page.locator(`[data-shape='${block}']`).click();
      await page.locator(".canvas").press("b");
      await page.getByText(`opened at ${block}.y is added to the text`).first().waitFor();
    }
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+s");
    await page.waitForFunction(() => document.querySelector(".bar-file button").disabled);
    const line = (signal) => `{from: ${signal}, to: ${signal}, open: ${signal}}`;
    assert.equal(studio.file, taken.replace("to: plant}\n", `to: plant}\n     loop2: ${line("control.y")}\n     loop3: ${line("plant.y")}\n`)
      .replace("y: plant}\n", `y: plant}, {plot: bode, of: loop2, title: The loop opened at control.y}, {plot: bode, of: loop3, title: The loop opened at plant.y}]\n`).replace("figure: {", "figure: [{"));
    studio.run();
    assert.deepEqual(studio.errors, []);
  } finally {
    await studio.close();
  }
});
