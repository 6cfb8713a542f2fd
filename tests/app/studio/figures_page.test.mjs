// Figures and mechanisms in Chromium.

import assert from "node:assert/strict";
import {test} from "node:test";
import {until} from "./browser.mjs";
import {figureOf, loaded, skip, text, withPage} from "./views_page.mjs";

test("figures are drawn again as the run goes on, and not while they are out of sight", {skip}, async () => {
  let drawings = 0;
  const answers = {"run.load": () => ({...loaded, figures: 1}), figures: () => ({figures: [figureOf(100 * ++drawings)]})};
  await withPage(answers, "figures", {}, async ({page, news}) => {
    await page.waitForSelector(".figure svg");
    assert.match(await page.locator(".figure-sheet").getAttribute("aria-label"), /position \[mm\] from −1 to 1 over time \[s\]/);
    const drawnPoints = () => page.evaluate(() => Math.max(...[...document.querySelectorAll(".figure path")].map((path) => path.getAttribute("d").split("L").length)));
    news({news: "run", run: 1, state: "playing", time: 0.1, tick: 100, rate: 1, wanted: 1, missed: 0, compiled: false, fault: null});
    await until(async () => (await drawnPoints()) >= 300, "it grows");
    await page.locator("#tab-scene").click();
    await page.waitForTimeout(500);
    const before = drawings;
    await page.waitForTimeout(1200);
    assert.equal(drawings, before);
  });
});

test("a figure of very many points is painted on a canvas", {skip}, () =>
  withPage({"run.load": () => ({...loaded, figures: 1}), figures: () => ({figures: [figureOf(30_000)]})}, "figures", {}, async ({page}) => {
    await page.waitForSelector(".figure canvas");
    await until(() => page.evaluate(() => {
      const canvas = document.querySelector(".figure canvas"), {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return data.some((value, i) => i % 4 === 2 && value > 150);
    }), "the curve is on it");
    assert.ok((await page.locator(".figure text").count()) > 10, "its labels are letters");
  }));

test("a mechanism moves in three dimensions, and three is loaded only then", {skip}, async () => {
  const pin = ["p.1", "p.2", "p.3"], columns = new Map(pin.map((name, i) => [name, 7 + i]));
  const rig = {title: "platform", dimensions: 3, axes: ["x", "y", "z"], elements: [
    {kind: "damper", name: "left MR damper", body: 0.13, points: [[-0.14, 0.38, 0], pin]}, {kind: "damper", name: "right MR damper", body: 0.13, points: [[0.14, 0.38, 0], pin]},
    {kind: "damper", name: "third MR damper", body: 0.13, points: [[0, 0.2, 0.224], pin]}, {kind: "universal", points: [[-0.14, 0.38, 0]]}, {kind: "end_effector", name: "end-effector", points: [pin]}]};
  let wanted;
  const answers = {"run.load": () => loaded, mechanism: () => ({mechanisms: [rig]}), "scope.signal": ({expression}) => ({column: columns.get(expression), name: expression, unit: "m", scale: 1}),
    "data.want": ({views}) => { wanted = views.find(({columns: own}) => own.includes(7)) ?? wanted; return {}; }};
  await withPage(answers, undefined, {}, async ({page, frame}) => {
    const scripts = [];
    page.on("request", (request) => scripts.push(request.url()));
    await page.waitForTimeout(500);
    assert.ok(!(await page.evaluate(() => performance.getEntriesByType("resource").some(({name}) => name.includes("mechanism_stage")))), "not before it is seen");
    await page.locator("#tab-mechanism").click();
    await until(() => wanted, "it follows the signals");
    frame({view: wanted.view, time: [0, 0.1], columns: [[0, 0], [0.2, 0.2], [0, 0]]});
    await until(async () => (await text(page, ".mechanism-facts"))?.includes("third MR damper224 mm long"), "lengths stand beside it");
    frame({view: wanted.view, sequence: 2, time: [0.2], columns: [[0], [0.2], [0.024]]});
    await until(async () => (await text(page, ".mechanism-facts"))?.includes("third MR damper200 mm long"), "and follow the run");
    assert.ok(scripts.some((one) => one.includes("mechanism_stage")));
    assert.ok((await page.locator(".mechanism-labels span:visible").count()) >= 4, "its parts have names");
    const place = () => page.locator(".mechanism-labels span", {hasText: "third MR damper"}).evaluate((one) => one.style.transform);
    const before = await place();
    await page.locator(".mechanism-canvas").focus();
    await page.keyboard.press("ArrowLeft");
    await until(async () => (await place()) !== before, "keys turn it");
  });
});

test("names in a mechanism lie neither on one another nor over the edge, also in a small view", {skip}, async () => {
  const at = (x, y) => [x, y, 0], elements = ["linear MR damper", "linear potentiometer", "load cell", "rod", "second rod"].map((name, i) => ({kind: "rod", name, points: [at(0, 0.001 * i), at(0.1, 0.001 * i)]}));
  const answers = {"run.load": () => loaded, mechanism: () => ({mechanisms: [{title: "close", dimensions: 2, axes: ["x", "z"], elements}]})};
  for (const [width, height] of [[1400, 900], [400, 500]])
    await withPage(answers, "mechanism", {width, height}, async ({page}) => {
      const boxes = () => page.evaluate(() => {
        const inside = (one) => { const {left, right, top, bottom} = one.getBoundingClientRect(); return {left, right, top, bottom, name: one.textContent}; };
        return [inside(document.querySelector(".mechanism-stage")), ...[...document.querySelectorAll(".mechanism-labels span")].filter((one) => one.style.visibility === "visible").map(inside)];
      });
      await until(async () => (await boxes()).length > 3, "names are seen");
      const [stage, ...names] = await boxes();
      for (const [i, one] of names.entries()) {
        assert.ok(one.left >= stage.left && one.right <= stage.right && one.top >= stage.top - 4 && one.bottom <= stage.bottom + 4, `${one.name} is cut off`);
        for (const other of names.slice(i + 1)) assert.ok(one.right <= other.left || other.right <= one.left || one.bottom <= other.top + 3 || other.bottom <= one.top + 3, `${one.name} lies on ${other.name}`);
      }
    });
});
