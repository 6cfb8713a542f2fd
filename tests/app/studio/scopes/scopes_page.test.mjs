// Scopes, run bar and tuning as who sits before them meets them, on a run that is made up.

import assert from "node:assert/strict";
import {existsSync, readFileSync} from "node:fs";
import {after, before, test} from "node:test";
import {contrasts} from "../../../gallery/inspect.mjs";
import {served} from "./bundled.mjs";

const playwright = await import("playwright-core").then((all) => all.default ?? all, () => undefined);
const executablePath = [process.env.STEPWIRE_CHROMIUM, "/usr/bin/chromium"].find((path) => path && existsSync(path));
const skip = !playwright ? "playwright-core is not installed: npm ci in tests/app/studio" : !executablePath ? "chromium is not installed" : false;
const options = {skip, timeout: 120_000};
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
async function at(until, action, {query = "", ...more} = {}) {
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

async function run(page, until) {
  await page.evaluate(() => studio.context.run.play(5));
  await page.waitForFunction((time) => studio.context.run.news.time >= time, until);
  await page.evaluate(() => studio.context.run.pause());
  await page.waitForFunction((time) => studio.context.run.news.state === "paused" && studio.board.scopes[0].feed.frame?.newest >= time, until);
  await page.waitForTimeout(150);
}

const over = (page, scope = 0) => page.locator(".scope").nth(scope).locator(".u-over");
const menu = async (page, scope, entry) => {
  await page.locator(".scope").nth(scope).getByRole("button", {name: "What may be done"}).click();
  await page.getByRole("menuitem", {name: entry}).click();
};
const state = (page) => page.locator(".scope-bar .chip").first().textContent();

test("wheel stops following while data go on, F follows again", options, () => at(2, async (page) => {
  await page.evaluate(() => studio.context.run.play(1));
  await page.waitForFunction(() => studio.context.run.news.state === "playing");
  assert.equal(await state(page), "following");
  await over(page).hover({position: {x: 100, y: 40}});
  await page.mouse.wheel(0, -300);
  await page.waitForFunction(() => !studio.board.shared.window.isFollowing);
  assert.match(await state(page), /^looking back/);
  const [seen, time] = await page.evaluate(() => [studio.board.shared.window.at(0), studio.context.run.news.time]);
  await page.waitForFunction((before) => studio.context.run.news.time > before + 0.3, time);
  assert.deepEqual(await page.evaluate(() => studio.board.shared.window.at(studio.context.run.time)), seen);
  await page.locator("body").press("f");
  assert.ok(await page.evaluate(() => studio.board.shared.window.isFollowing));
}));

test("space pauses the model and not the scopes' time; a full stop is one tick", options, () => at(1, async (page) => {
  const tick = () => page.evaluate(() => studio.context.run.news.tick);
  const before = await tick();
  await page.locator("body").press(".");
  await page.waitForFunction((old) => studio.context.run.news.tick === old + 1, before);
  assert.match(await state(page), /paused/);
  await page.locator("body").press(" ");
  await page.waitForFunction(() => studio.context.run.news.state === "playing");
  await page.locator("body").press(" ");
  await page.waitForFunction(() => studio.context.run.news.state === "paused");
}));

test("a drag chooses a stretch, a double click goes back", options, () => at(3, async (page) => {
  const box = await over(page).boundingBox();
  await page.mouse.move(box.x + box.width * 0.1, box.y + 40);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.2, box.y + 40, {steps: 4});
  await page.mouse.up();
  const {low, high} = await page.evaluate(() => studio.board.shared.window.at(0));
  assert.ok(Math.abs(low - 1) < 0.05 && Math.abs(high - 2) < 0.05, `${low} to ${high}`);
  await over(page).dblclick({position: {x: 50, y: 40}});
  assert.ok(await page.evaluate(() => studio.board.shared.window.isFollowing));
}));

test("a peak of one sample is drawn to its height, near and far", options, () => at(30, async (page) => {
  const peak = () => page.evaluate(() => {
    const scope = studio.board.scopes[0], samples = scope.feed.samples.get(0);
    return {fed: Math.max(...samples.high), range: scope.groups[0].range.now};
  });
  for (const width of [30, 10, 100]) {
    await page.evaluate((seconds) => studio.board.shared.window.look({low: 0, high: seconds}), width);
    await page.waitForTimeout(400);
    const {fed, range} = await peak();
    assert.ok(fed > 0.065 && range.high > fed, `${width} s: ${fed}, ${range.high}`);
  }
}));

test("arrows move the cursor, which is said with its values", options, () => at(3, async (page) => {
  await page.locator(".scope").first().focus();
  await page.keyboard.press("Home");
  for (let i = 0; i < 5; ++i) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Alt+ArrowRight");
  await page.keyboard.press("Shift+End");
  const {a, b} = await page.evaluate(() => ({a: studio.board.shared.cursors.a, b: studio.board.shared.cursors.b}));
  assert.ok(Math.abs(a - 0.501) < 1e-9, `A ${a}`);
  assert.ok(b > 2.9, `B ${b}`);
  await page.waitForFunction(() => [...document.querySelectorAll("[aria-live]")].some((region) => /^A 0.501 s, B .*1\/\(B − A\).*cart.position .* mm/.test(region.textContent)));
  await page.keyboard.press("Escape");
  assert.ok(await page.locator(".statistics").isHidden());
}));

test("what lies between the cursors becomes a line of claims by a click", options, () => at(3, async (page) => {
  await page.evaluate(() => {
    document.addEventListener("studio:insert", (event) => { window.inserted = event.detail; event.preventDefault(); });
    studio.board.shared.cursors.put("a", 1, 0.001);
    studio.board.shared.cursors.put("b", 2, 0.001);
  });
  const row = page.locator(".statistics tbody tr").first();
  await row.waitFor();
  await row.getByRole("button").nth(3).click();
  const {section, text} = await page.evaluate(() => window.inserted);
  assert.equal(section, "claims");
  assert.match(text, /^\{that: the greatest cart.position from 1 s to 2 s is 6\d\.\d+ mm, where: time >= 1 s && time <= 2 s, max: cart.position, equals: 6\d\.\d+ mm, within: 1 %\}$/);
}));

test("a name dropped on a scope is drawn in it, beside the scopes in a new one; a name that is none says so", options, () => at(1, async (page) => {
  const drop = (selector, text) => page.evaluate(([where, what]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.setData("text/plain", what);
    document.querySelector(where).dispatchEvent(new DragEvent("drop", {dataTransfer, bubbles: true, cancelable: true}));
  }, [selector, text]);
  await page.evaluate(() => { window.before = studio.board.scopes[0].groups[0].range; });
  await drop(".scope", "rig.sensor[8]");
  await page.waitForFunction(() => studio.board.scopes[0].traces.length === 4);
  await page.waitForTimeout(200);
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
  await menu(page, 0, "Show against the first signal");
  await page.waitForTimeout(300);
  assert.ok(await page.evaluate(() => studio.board.scopes[0].isAgainst && studio.board.scopes[0].groups[0].traces.length === 2));
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
  await page.locator(".scope-note").first().getByText("behind: 9 runs with gain from 0 to 3").waitFor();
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
  await menu(page, 0, "Show against the first signal");
  await page.waitForTimeout(300);
  const against = await saved("Save the picture as SVG");
  assert.ok((against.match(/<path/g) ?? []).length === 2 && !against.includes("NaN") && against.includes("cart.position mm"));
  await menu(page, 0, "Show over time");
  assert.match(await saved("Save the range as CSV"), /^time \[s\]/);
  await menu(page, 0, "Copy as figure:");
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
  await page.getByRole("menuitem", {name: "The scopes of the file again"}).click();
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
    await page.waitForTimeout(200);
    const {content, window: own} = await page.evaluate(() => ({content: document.documentElement.scrollWidth, window: document.documentElement.clientWidth}));
    assert.ok(content <= own, `${content} in ${own}`);
    for (const {ratio, text} of await page.evaluate(contrasts)) assert.ok(ratio >= 4.5, `${text}: ${ratio}`);
  }, {viewport: {width, height: 700}, colorScheme}));
