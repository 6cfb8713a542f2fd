// Examples, tour and licences in Chromium; texts of a diagram cannot inject anything into any view.

import assert from "node:assert/strict";
import {test} from "node:test";
import {until} from "./browser.mjs";
import {figureOf, info, loaded, more, skip, text, withPage} from "./views_page.mjs";

const entries = [{entry: 0, name: "01-first-diagram", title: "A first diagram", group: "Examples"}, {entry: 1, name: "fig38-virtual-environment-inside", title: "Virtual environment", group: "Thesis", caption: "the ball in the ring"}];
test("an example is found, copied and opened", {skip}, () => {
  const files = [{file: 0, name: "test.yaml", writable: true, part: false}];
  const answers = {gallery: () => ({entries}), files: () => ({files}), open: ({file}) => ({name: files[file].name, text: "stepwire: 1\n", hash: "0", draft: null, version: 0}),
    "gallery.copy": ({name}) => {
      if (name === "taken.yaml") throw new Error("there is a file taken.yaml already");
      files.push({file: 1, name, writable: true, part: false});
      return {file: 1};
    }};
  return withPage(answers, undefined, {}, async ({page, calls}) => {
    await more(page, "Examples…");
    await page.getByRole("combobox", {name: "Search examples"}).fill("figure 38");
    await until(async () => (await page.locator(".gallery-entry").count()) === 1, "one is found");
    await page.getByLabel("Name of the copy").fill("taken.yaml");
    await page.keyboard.press("Enter");
    await until(async () => /taken\.yaml already/.test(await text(page, ".gallery-fault")), "a fault stands in the dialog");
    await page.getByLabel("Name of the copy").fill("mine.yaml");
    await page.keyboard.press("Enter");
    await until(() => calls.some(({call, file}) => call === "run.load" && file === 1), "the copy is run");
    assert.deepEqual(calls.filter(({call}) => call === "gallery.copy").map(({entry, name}) => [entry, name]), [[1, "taken.yaml"], [1, "mine.yaml"]]);
    await until(async () => (await page.locator("dialog").count()) === 0, "the dialog closes");
  });
});

test("who is new is offered the tour once; keys go through it", {skip}, async () => {
  let state = {}, user = {};
  const answers = {gallery: () => ({entries}), "state.get": () => ({state}), "state.put": (put) => { state = put.state; return {}; }, "user.get": () => ({state: user}), "user.put": (put) => { user = put.state; return {}; }};
  await withPage(answers, undefined, {reducedMotion: "reduce"}, async ({page}) => {
    await page.getByRole("button", {name: "With this diagram"}).click();
    await page.waitForSelector(".tour-card");
    for (let i = 0; i < 2; ++i) await page.keyboard.press("ArrowRight");
    await until(async () => (await text(page, ".tour-count")) === "3 of 7", "arrows go on");
    const card = await page.locator(".tour-card").boundingBox();
    assert.ok(card.x >= 0 && card.y >= 0 && card.x + card.width <= 1400 && card.y + card.height <= 900);
    assert.equal(await page.locator(".tour-ring").evaluate((one) => getComputedStyle(one).transitionDuration), "0s", "nothing moves by itself");
    await page.keyboard.press("Escape");
    assert.equal(await page.locator(".tour-card").count(), 0);
    await until(() => user["tour.seen"] === true, "it is remembered for the user");
  });
  state = {};
  await withPage(answers, undefined, {}, async ({page}) => {
    await page.waitForTimeout(800);
    assert.equal(await page.locator("dialog").count(), 0);
  });
});

test("about lists what the page is made of, with licences", {skip}, () => withPage({}, undefined, {}, async ({page}) => {
  await more(page, "About and licences");
  await until(async () => (await page.locator(".licence").count()) > 10, "packages are listed");
  await page.locator(".licence", {hasText: "elkjs"}).locator("summary").click();
  await until(async () => /Eclipse Public License/i.test(await page.locator(".licence", {hasText: "elkjs"}).locator("pre").textContent()), "with their texts");
}));

test("what a diagram says does nothing in scene, figures and examples", {skip}, async () => {
  const evil = `"><img src=x onerror="window.hit=1"><script>window.hit=1</script>`;
  const figure = figureOf(10);
  Object.assign(figure.panels[0], {title: evil, legend: "above", texts: [{text: evil}]});
  Object.assign(figure.panels[0].marks[0], {legend: evil});
  const rig = {panel: "rig", graph: {title: evil, dimensions: 2, axes: [evil, "y"], elements: [{kind: "damper", name: evil, points: [[0, 0], [0.1, 0]]}]}};
  const answers = {"run.load": () => ({...loaded, scene: true, figures: 2}), scene: () => ({scene: {...info, title: evil, pointer: {...info.pointer, text: evil}, objects: [{name: evil, kind: "text", text: evil, walls: []}]}}),
    figures: () => ({figures: [figure, {title: evil, panels: [rig]}]}), gallery: () => ({entries: [{entry: 0, name: evil, title: evil, group: evil, caption: evil}]})};
  await withPage(answers, "figures", {}, async ({page, news}) => {
    await until(async () => (await page.locator(".figure svg").count()) === 2, "both are drawn");
    await page.locator("#tab-scene").click();
    news({news: "scene", time: 0, shapes: [{object: 0, points: [[0, 0]], size: 0.001, width: 0, color: "#ffffff", shown: true}]});
    await page.getByRole("button", {name: "Describe"}).click();
    await more(page, "Examples…");
    await page.waitForSelector(".gallery-entry");
    assert.equal(await page.evaluate(() => window.hit), undefined);
    assert.equal(await page.locator("img").count(), 0);
  });
});
