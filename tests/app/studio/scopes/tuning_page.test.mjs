// Sliders and the run bar in the browser.

import assert from "node:assert/strict";
import {test} from "node:test";
import {at, options} from "./scopes_page.mjs";

test("a slider sets the run and shows what it took, with its tick; what is refused says why", options, () => at(1, async (page) => {
  const slider = page.getByRole("slider", {name: "gain, of all signals"});
  await slider.focus();
  await page.keyboard.press("End");
  await page.locator(".tuned").first().getByText(/^3 from tick \d+$/).waitFor();
  assert.equal(await page.evaluate(() => studio.context.run.loaded.parameters[0].value), 3);
  const field = page.getByRole("textbox", {name: "gain, of all signals"});
  await field.fill("7");
  await field.press("Enter");
  await page.locator(".tuned-fault").getByText("gain: 7 is above 3").waitFor();
  assert.equal(await field.getAttribute("aria-invalid"), "true");
}));

test("a tuned value goes to the text as an event with name and text", options, () => at(0, async (page) => {
  await page.evaluate(() => document.addEventListener("studio:write", (event) => { window.written = event.detail; }));
  const field = page.getByRole("textbox", {name: "mass, of the cart"});
  await field.fill("3");
  await field.press("Enter");
  await page.getByRole("button", {name: /Write this value .*: mass/}).click();
  assert.deepEqual(await page.evaluate(() => window.written), {name: "mass", text: "3 kg"});
}));

test("a sweep over a slider is drawn behind the scopes", options, () => at(1, async (page) => {
  await page.getByRole("button", {name: /Run it at 9 values.*: gain/}).click();
  await page.locator(".scope-note").first().getByText("background: 9 runs with gain from 0 to 3").waitFor();
  await page.waitForFunction(() => studio.board.scopes[0].groups[0].range.now.high > 0.058);
}));

test("dragging the time of the run goes back, and play goes on from there", options, () => at(4, async (page) => {
  const scrub = page.getByRole("slider", {name: "Time of the run"});
  await scrub.focus();
  await page.keyboard.press("Home");
  await page.waitForFunction(() => studio.context.run.news.time === 0);
  await page.evaluate(() => studio.context.run.seek(2));
  await page.evaluate(() => studio.context.run.play(1));
  await page.waitForFunction(() => studio.context.run.news.time > 2.05 && studio.context.run.news.time < 3.9);
}));

test("the list of claims goes away by Esc and by a click elsewhere", options, () => at(0, async (page) => {
  const list = page.getByText("the cart stays within 60 mm"), claims = page.locator(".verdict-counts");
  await claims.focus();
  await page.keyboard.press("Enter");
  await list.waitFor();
  await page.keyboard.press("Escape");
  await list.waitFor({state: "hidden"});
  await claims.click();
  await list.waitFor();
  await page.locator(".scope").first().click({position: {x: 5, y: 5}});
  await list.waitFor({state: "hidden"});
}));
