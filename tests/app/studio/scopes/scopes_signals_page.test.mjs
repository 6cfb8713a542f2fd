// Adding of signals to scopes in the browser.

import assert from "node:assert/strict";
import {test} from "node:test";
import {at, menu, options, run, settled} from "./scopes_page.mjs";

test("a name dropped on a scope is drawn in it, beside the scopes in a new one; a name that is none says so", options, () => at(1, async (page) => {
  const drop = (selector, text) => page.evaluate(([where, what]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.setData("text/plain", what);
    document.querySelector(where).dispatchEvent(new DragEvent("drop", {dataTransfer, bubbles: true, cancelable: true}));
  }, [selector, text]);
  await page.evaluate(() => { window.before = studio.board.scopes[0].groups[0].range; });
  await drop(".scope", "rig.sensor[8]");
  await page.waitForFunction(() => studio.board.scopes[0].traces.length === 4);
  await settled(page);
  assert.ok(await page.evaluate(() => studio.board.scopes[0].groups[0].range === window.before));
  await drop(".scope-grid", "cart.position in mm");
  await page.waitForFunction(() => studio.board.scopes.length === 3);
  assert.equal(await page.evaluate(() => studio.board.scopes[2].traces[0].unit.text), "mm");
  await drop(".scope", "<img src=x>");
  await page.locator(".notice-fault").getByText("there is no signal").waitFor();
}));

test("the thirteenth signal of a scope is refused", options, () => at(0, async (page) => {
  await page.evaluate(async () => { for (let i = 1; i < 12; ++i) await studio.board.addSource(studio.board.scopes[1], `rig.sensor[${i}]`); });
  assert.equal(await page.evaluate(() => studio.board.scopes[1].traces.length), 12);
  assert.equal(await page.evaluate(() => new Set(studio.board.scopes[1].traces.map(({style}) => style)).size), 12);
}));

test("signals are searched and added by the keyboard", options, () => at(1, async (page) => {
  await page.locator("body").press("a");
  await page.keyboard.type("sensor[9]");
  await page.keyboard.press("Shift+Enter");
  await page.waitForFunction(() => studio.board.scopes.at(-1).traces[0]?.source === "rig.sensor[9]");
  await page.getByRole("searchbox", {name: "Signal or expression"}).fill("no.such");
  await page.keyboard.press("Enter");
  await page.locator(".signal-fault").getByText("there is no signal 'no.such'").waitFor();
}));

test("one signal against another, and back", options, () => at(3, async (page) => {
  await menu(page, 0, "Plot against the first signal");
  await page.waitForFunction(() => studio.board.scopes[0].isAgainst && studio.board.scopes[0].groups[0]?.traces.length === 2);
  await menu(page, 0, "Show over time");
  assert.ok(await page.evaluate(() => !studio.board.scopes[0].isAgainst));
}));

test("a kept run lies behind the next one, and their difference is judged by a tolerance", options, () => at(2, async (page) => {
  await page.locator("body").press("p");
  await page.waitForFunction(() => studio.board.shared.pins.all.length === 1);
  await page.evaluate(async () => {
    await studio.context.run.restart();
    await studio.context.run.set("gain", 2);
  });
  await run(page, 2);
  await menu(page, 0, "Show the difference to run 1");
  const note = page.locator(".scope-note").first();
  await note.getByText(/cart.position: largest difference 2\d(\.\d+)? mm at .*; beyond .* in (9\d|100) % of the time/).waitFor();
  await page.locator(".tolerance").first().fill("100");
  await note.getByText("within 100 mm").waitFor();
}));
