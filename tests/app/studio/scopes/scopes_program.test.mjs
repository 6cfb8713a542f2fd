// Scopes on a run of the program: their displayed, saved and inserted values equal those of `run`.

import assert from "node:assert/strict";
import {execFileSync, spawnSync} from "node:child_process";
import {readFileSync} from "node:fs";
import {test} from "node:test";
import {until} from "../browser.mjs";
import {missing, Studio} from "../studio.mjs";

const options = {skip: missing};
const cart = `stepwire: 1
title: A cart on a spring
step: 1 ms
stop: 3 s
solver: rk4
parameters:
  mass: {value: 2 kg, above: 0 kg, doc: of the cart}
blocks:
  push:   {block: Step, time: 0.5 s, after: 10 N}
  net:    {block: Sum, signs: "+--", u: [push, spring, damper]}
  cart:   {block: Mass, force: net, mass: $mass}
  spring: {block: Gain, u: cart.position, gain: 200 N/m}
  damper: {block: Gain, u: cart.velocity, gain: 8 N s/m}
record: [push, cart.position, spring]
figure: {plot: lines, x: time in s, y: cart.position in mm, y_label: position}
claims:
  - {that: the cart ends where the spring holds the push, final: cart.position, equals: 50 mm, within: 1 %}
`;

/** Constant except for a peak of one tick in 200,000. */
const peak = `stepwire: 1
title: One tick
step: 1 ms
stop: 200 s
solver: rk4
blocks:
  spike: {block: Pulse, amplitude: 1 N, period: 1000 s, width: 1e-6, delay: 123.456 s}
record: [spike]
`;

/** Opens a studio and plays its run to the end. */
async function ended(action, text = cart) {
  const studio = await Studio.opened(text), {page} = studio;
  try {
    await page.locator(".scope .trace").first().waitFor();
    await page.getByRole("button", {name: "Dismiss"}).click();
    await toEnd(page);
    await action(studio, page);
    assert.deepEqual(studio.errors, []);
  } finally {
    await studio.close();
  }
}

async function toEnd(page) {
  await page.locator(".run-buttons select").selectOption("0");
  await page.locator(".play").click();
  await page.locator(".scope-bar .chip").first().getByText("model ended").waitFor();
}

const menu = async (page, entry) => {
  await page.locator(".scope").first().getByRole("button", {name: "Menu of"}).click();
  await page.getByRole("menuitem", {name: entry}).click();
};

/** Sets cursors to both ends of the window, by keys. */
async function cursors(page) {
  await page.locator(".scope").first().focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("Shift+End");
  await page.locator(".statistics tbody td").first().waitFor();
}

test("a claim made by a click holds in `run`, and statistics are those of its samples", options, () => ended(async (studio, page) => {
  await cursors(page);
  const samples = studio.run()["cart.position"], cells = page.locator(".statistics tbody tr").first().locator("td");
  const greatest = Math.max(...samples) * 1000, mean = (samples.reduce((sum, value) => sum + value, 0) / samples.length) * 1000;
  assert.equal(await cells.nth(4).innerText(), `${Number(greatest.toPrecision(5))} mm`);
  assert.equal(await cells.nth(5).innerText(), `${Number(mean.toPrecision(5))} mm`);
  for (const [i, column] of [0, 3, 4, 5, 6].entries()) {
    await cells.nth(column).getByRole("button").click();
    await page.waitForFunction((count) => (document.querySelector(".cm-content").textContent.match(/that:/g) ?? []).length === count, i + 2);
  }
  await page.keyboard.press("Control+s");
  await until(() => studio.file.match(/that:/g).length === 6, "the file has all claims");
  const said = execFileSync(process.env.STEPWIRE_PROGRAM, ["run", studio.path], {encoding: "utf8"});
  assert.equal(said.match(/^ +ok /gm).length, 6, said);
}));

test("the range is saved as the numbers of `run`", options, () => ended(async (studio, page) => {
  const download = page.waitForEvent("download");
  await menu(page, "Save the range as CSV");
  const [head, ...rows] = readFileSync(await (await download).path(), "utf8").trim().split(/\r?\n/), samples = studio.run()["cart.position"];
  assert.match(head, /^time \[s\],.*\[mm\]$/);
  assert.equal(rows.length, samples.length);
  rows.forEach((row, i) => assert.ok(Math.abs(Number(row.split(",")[1]) - 1000 * samples[i]) <= 1e-9 * (1 + Math.abs(1000 * samples[i])), row));
}));

test("a tuned value stays after a restart; the kept run and the next one differ by what it does", options, () => ended(async (studio, page) => {
  await page.locator(".scope").first().focus();
  await page.keyboard.press("p");
  await page.locator(".pins").getByText("mass 2 kg").waitFor();
  const field = page.getByRole("textbox", {name: "mass, of the cart"});
  await field.fill("3 kg");
  await field.press("Enter");
  await page.locator(".tuned-echo").first().getByText("3 kg from tick").waitFor();
  await page.getByRole("button", {name: "Restart"}).click();
  await page.locator(".scope-bar .chip").first().getByText("model paused").waitFor();
  await toEnd(page);
  await menu(page, "Show the difference to run 1");
  const before = studio.run()["cart.position"];
  spawnSync(process.env.STEPWIRE_PROGRAM, ["run", studio.path, "--set", "mass=3kg", "--out", `${studio.folder}/heavy`]);  // its claim fails
  const rows = readFileSync(`${studio.folder}/heavy/signals.csv`, "utf8").trim().split("\n").filter((line) => !line.startsWith("#")), names = rows[0].split(",");
  const column = names.findIndex((name) => name.startsWith("cart.position")), worst = Math.max(...rows.slice(1).map((row, i) => Math.abs(Number(row.split(",")[column]) - before[i])));
  await page.locator(".scope-note").first().getByText(`largest difference ${Number((1000 * worst).toPrecision(5))} mm`).waitFor();
}));

test("an expression with units is drawn beside, and its fault is said where there is none", options, () => ended(async (_, page) => {
  await page.locator(".scope").first().focus();
  await page.keyboard.press("a");
  const search = page.getByRole("searchbox", {name: "Signal or expression"});
  await search.fill("200 N/m * cart.position - spring in mN");
  await search.press("Shift+Enter");
  await page.locator(".scope").nth(1).locator(".trace-value").getByText("0 mN").waitFor();
  await search.fill("cart.positon in mm");
  await search.press("Enter");
  await page.locator(".signal-fault").getByText("did you mean 'cart.position'?").waitFor();
}));

test("a peak of one tick is seen among 200,000", options, () => ended(async (studio, page) => {
  assert.equal(studio.run().spike.filter((value) => value !== 0).length, 1);
  await page.getByLabel("Time span shown").selectOption("300");
  const seen = () => page.evaluate(() => {
    const canvas = document.querySelector(".scope canvas"), context = canvas.getContext("2d"), over = document.querySelector(".scope .u-over"), ratio = devicePixelRatio;
    const left = Math.round(over.offsetLeft * ratio), top = Math.round(over.offsetTop * ratio), width = Math.round(over.clientWidth * ratio), height = Math.round(over.clientHeight * ratio);
    const {data} = context.getImageData(left, top, width, height), columns = [];
    for (let x = 0; x < width; ++x) {
      const blue = Array.from({length: height}, (_, y) => 4 * (y * width + x)).filter((at) => data[at + 2] > data[at] + 60).length;
      if (blue > 0.7 * height) columns.push(x / width);
    }
    return columns;
  });
  let found;
  await until(async () => (found = await seen()).length > 0, "there is a peak");
  assert.ok(found.every((share) => Math.abs(share - 123.456 / 300) < 0.01), `columns ${found}`);
}, peak));
