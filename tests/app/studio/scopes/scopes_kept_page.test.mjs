// Storage, export and announcements of scopes in the browser.

import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {test} from "node:test";
import {contrasts} from "../../../gallery/inspect.mjs";
import {at, menu, options, over, settled} from "./scopes_page.mjs";

test("a scope is saved as a picture, its range as CSV, and copied as a figure", options, () => at(3, async (page) => {
  const saved = async (entry) => {
    const download = page.waitForEvent("download");
    await menu(page, 0, entry);
    return readFileSync(await (await download).path(), "utf8");
  };
  const picture = await saved("Save the picture as SVG");
  assert.match(picture, /^<svg xmlns="http:\/\/www.w3.org\/2000\/svg"/);
  assert.match(picture, /cart.position<\/text>/);
  assert.ok((picture.match(/<path/g) ?? []).length === 3);
  await menu(page, 0, "Plot against the first signal");
  await page.waitForFunction(() => studio.board.scopes[0].isAgainst);
  await settled(page);
  const against = await saved("Save the picture as SVG");
  assert.ok((against.match(/<path/g) ?? []).length === 2 && !against.includes("NaN") && against.includes("cart.position mm"));
  await menu(page, 0, "Show over time");
  assert.match(await saved("Save the range as CSV"), /^time \[s\]/);
  await menu(page, 0, "Copy as a section figure");
  assert.match(await page.evaluate(() => navigator.clipboard.readText()), /^figure: \{plot: lines, x: time in s, y: \[cart.position in mm, /);
}));

test("values are there as a table", options, () => at(2, async (page) => {
  await menu(page, 0, "Table of values");
  const table = page.getByRole("dialog").getByRole("table");
  assert.equal(await table.getByRole("row").count(), 22);
  assert.match(await table.getByRole("row").nth(3).textContent(), /mm/);
}));

test("two fingers stretch time and move it", options, () => at(5, async (page) => {
  const box = await over(page).boundingBox(), session = await page.context().newCDPSession(page), y = box.y + 40;
  const touch = (type, ...xs) => session.send("Input.dispatchTouchEvent", {type, touchPoints: xs.map((x, id) => ({x: box.x + x, y, id}))});
  await touch("touchStart", 100);
  await touch("touchStart", 100, 150);
  for (let i = 1; i <= 10; ++i) await touch("touchMove", 100 - 5 * i, 150 + 5 * i);
  await touch("touchEnd");
  const {low, high} = await page.evaluate(() => studio.board.shared.window.at(0));
  assert.ok(Math.abs(high - low - 10 / 3) < 0.4, `${low} to ${high}`);
}, {hasTouch: true}));

test("scopes are there again after the page is loaded anew, and those of the file on demand", options, () => at(1, async (page) => {
  await page.evaluate(() => studio.board.addSource(undefined, "rig.sensor[7]"));
  await page.waitForFunction(() => JSON.parse(localStorage.getItem("state") ?? "{}")["scopes cart.yaml"]?.scopes.length === 3);
  await page.reload();
  await page.waitForFunction(() => window.studio?.board.scopes.length === 3);
  await page.waitForFunction(() => studio.board.scopes[2].traces[0].column === 7);
  await page.getByRole("button", {name: "More about scopes"}).click();
  await page.getByRole("menuitem", {name: "Reset to the scopes of the file"}).click();
  assert.equal(await page.evaluate(() => studio.board.scopes.length), 2);
}));

test("scopes follow the figures of the text until they are changed by hand", options, () => at(1, async (page) => {
  const reload = (title) => page.evaluate(async (text) => {
    const {connection, run} = studio.context, call = Object.getPrototypeOf(connection).call;
    connection.call = async (name, args) => {
      const result = await call.apply(connection, [name, args]);
      if (name === "run.load") result.scopes[0].title = text;
      return result;
    };
    await run.load(1);
  }, title);
  await page.evaluate(() => studio.board.shared.window.zoom(0.5, 1, 1));
  await reload("Of the text");
  await page.waitForFunction(() => studio.board.scopes[0].name === "Of the text");
  await page.evaluate(() => studio.board.addSource(studio.board.scopes[0], "rig.sensor[7]"));
  await reload("Of another text");
  await page.waitForTimeout(200);
  assert.deepEqual(await page.evaluate(() => [studio.board.scopes[0].name, studio.board.scopes[0].traces.length]), ["Of the text", 4]);
}));

test("texts of a diagram are no markup, wherever they are shown", options, () => at(0.5, async (page) => {
  const evil = '"><img src=x onerror=window.broken=1>';
  await page.evaluate((text) => {
    const {loaded} = studio.context.run;
    for (const column of loaded.columns) Object.assign(column, {name: text + column.column, unit: text});
    for (const parameter of loaded.parameters) Object.assign(parameter, {name: text, doc: text, text, unit: text});
    for (const scope of loaded.scopes) Object.assign(scope, {title: text, traces: scope.traces.map((trace) => ({...trace, label: text, unit: text}))});
    studio.board.reset();
    studio.tuning.load(loaded);
    studio.board.signals.fill(loaded.columns);
    studio.bar.verdicts.judge([{that: text, verdict: "FAIL", text}]);
    studio.context.run.listeners.emit("fan", {name: text, unit: text, columns: [], points: [{value: 1, time: [], columns: []}]});
    studio.board.shared.cursors.put("a", 0.2, 0.001);
  }, evil);
  await menu(page, 0, "Table of values");
  await page.waitForTimeout(500);
  assert.equal(await page.evaluate(() => window.broken), undefined);
  assert.equal(await page.locator("img").count(), 0);
}));

for (const width of [1400, 1024, 400]) for (const colorScheme of ["light", "dark"])
  test(`nothing hangs over the page, and all text stands out, at ${width} px, ${colorScheme}`, options, () => at(1, async (page) => {
    await page.evaluate(() => { studio.board.shared.cursors.put("a", 0.2, 0.001); studio.board.bar.showSignals(true); });
    await page.locator(".statistics tbody td").first().waitFor();
    await settled(page);
    const {content, window: own} = await page.evaluate(() => ({content: document.documentElement.scrollWidth, window: document.documentElement.clientWidth}));
    assert.ok(content <= own, `${content} in ${own}`);
    for (const {ratio, text} of await page.evaluate(contrasts)) assert.ok(ratio >= 4.5, `${text}: ${ratio}`);
  }, {viewport: {width, height: 700}, colorScheme}));
