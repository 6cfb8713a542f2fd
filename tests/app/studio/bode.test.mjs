// A Bode plot of the running loop: chosen by a wire of the drawing, written as two lines of text, and drawn anew when a slider moves.

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
/** At the gain K the loop K / ((0.1 s + 1)(0.05 s + 1)(0.02 s + 1)) is on the border of stability at K = 12.6, by Routh. */
const border = (0.1 + 0.05 + 0.02) * (1 / 0.1 + 1 / 0.05 + 1 / 0.02) - 1;
const margin = (page) => page.locator(".figure svg text").evaluateAll((all) => all.map((one) => parseFloat(one.textContent.replace("−", "-"))).find((_, i) => / dB$/.test(all[i].textContent)));

test("the loop is cut at a wire, its margins are seen, and follow the gain", {skip: missing}, async () => {
  const studio = await Studio.opened(text), {page} = studio;
  try {
    await page.getByRole("button", {name: "No, thank you"}).click();
    await page.locator("[data-shape='control']").click();
    await page.keyboard.press("w");
    await page.keyboard.press("b");
    await page.getByText("is added to the text").first().waitFor();
    await page.waitForFunction(() => /linear:\s*loop: \{from: (error|control)\.y, to: \1\.y, open: \1\.y\}figure:\s*- \{plot: bode, of: loop, title: The loop cut behind \1\.y\}/.test(document.querySelector(".cm-content").textContent));
    await page.getByRole("button", {name: "From the start"}).click();
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
