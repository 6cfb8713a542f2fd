// Figures, scene, mechanism, examples and tour in Chromium. The page is the built one: STUDIO_PAGE=FOLDER, else that of build/.

import assert from "node:assert/strict";
import {existsSync} from "node:fs";
import {dirname, join, resolve} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "../../..");
const folder = [process.env.STUDIO_PAGE, join(root, "build/studio"), join(root, "engine/app/studio/page/dist")].find((one) => one && existsSync(join(one, "index.html")));
const here = dirname(fileURLToPath(import.meta.url)), browser = process.env.STEPWIRE_CHROMIUM ?? "/usr/bin/chromium";
const skip = folder === undefined ? "the page is not built" : !existsSync(join(here, "node_modules")) ? "playwright-core is not installed: npm ci in tests/app/studio"
  : !existsSync(browser) && "there is no browser; on Debian it is the package chromium";
const {openPage} = skip ? {} : await import("./scene_page.mjs");

const loaded = {run: 1, step: 0.001, stop: 1, columns: [], parameters: [], scopes: [], inputs: [], scene: false, figures: 0, claims: []};
const text = (page, selector) => page.locator(selector).first().textContent();
/** Waits until something holds, and says what does not. */
async function until(holds, what) {
  for (let i = 0; i < 100; ++i) {
    if (await holds()) return;
    await new Promise((done) => setTimeout(done, 50));
  }
  assert.fail(what);
}

/** Opens the page with a pane in front, and closes it whatever happens. */
async function withPage(answers, pane, view, run) {
  const opened = await openPage(folder, answers, view);
  try {
    if (pane) {
      await opened.page.locator(`#tab-${pane}`).click();
      await opened.page.waitForTimeout(100);
    }
    await run(opened);
    assert.deepEqual(opened.errors, [], "errors of the page");
  } finally {
    await opened.close();
  }
}

const info = {
  title: "Ring", x: [-0.02, 0.02], y: [-0.01, 0.01], background: "#102030", pointer: {name: "pointer", held: "pointer_held", text: "Press and move: a spring pulls the ball to you."},
  objects: [{name: "walls", kind: "walls", text: "", walls: [{points: [[-0.019, -0.009], [0.019, -0.009], [0.019, 0.009], [-0.019, 0.009]], closed: true}]}, {name: "ball", kind: "point", text: "", walls: []}],
};
const instant = (x, y, input = null) => ({news: "scene", time: 0.5, input, shapes: [
  {object: 0, wall: 0, points: [], size: 0, width: 0.0004, color: "#00ff00", crossed: false, shown: true}, {object: 1, points: [[x, y]], size: 0.002, width: 0, color: "#ff0000", crossed: false, shown: true}]});
const withScene = {"run.load": () => ({...loaded, scene: true}), scene: () => ({scene: info})};
const samplesOf = (calls) => calls.filter(({call}) => call === "run.input").flatMap(({samples}) => samples);

/** The colour at a place of the scene. */
const colorAt = (page, x, y) => page.evaluate(([x, y, [x0, x1], [y0, y1]]) => {
  const canvas = document.querySelector(".scene-canvas"), pen = canvas.getContext("2d");
  return [...pen.getImageData(Math.round(((x - x0) / (x1 - x0)) * canvas.width), Math.round(((y1 - y) / (y1 - y0)) * canvas.height), 1, 1).data];
}, [x, y, info.x, info.y]);

test("a scene is drawn to scale, in the colours of its objects", {skip}, () => withPage(withScene, "scene", {}, async ({page, news, calls}) => {
  await page.waitForSelector(".scene-canvas");
  await until(() => calls.some(({call, on}) => call === "scene.watch" && on), "the scene is watched while it is seen");
  news(instant(0.005, 0.002));
  await until(async () => (await colorAt(page, 0.005, 0.002))[0] > 200, "the point is red where it is");
  assert.deepEqual((await colorAt(page, -0.01, -0.004)).slice(0, 3), [0x10, 0x20, 0x30], "the ground has its colour");
  const {width, height} = await page.locator(".scene-canvas").boundingBox();
  assert.ok(Math.abs(width / height - 2) < 0.02, "a metre is as long upward as to the right");
  await page.locator("#tab-figures").click();
  await until(() => calls.filter(({call}) => call === "scene.watch").at(-1).on === false, "what is not seen is not sent");
}));

test("a pointer is the hand: it takes hold, moves with the time of its events, and lets go", {skip}, () => withPage(withScene, "scene", {}, async ({page, calls, news}) => {
  const box = await page.locator(".scene-canvas").boundingBox();
  news(instant(0, 0));
  await page.mouse.move(box.x + 0.25 * box.width, box.y + 0.5 * box.height);
  assert.deepEqual(samplesOf(calls), [], "who only passes by is no hand");
  await page.mouse.down();
  await page.mouse.move(box.x + 0.75 * box.width, box.y + 0.25 * box.height, {steps: 8});
  await until(() => samplesOf(calls).some(({name, values}) => name === "pointer" && Math.abs(values[0] - 0.01) < 2e-4 && Math.abs(values[1] - 0.005) < 2e-4), "the last place arrives, in metres");
  assert.deepEqual(await page.locator(".scene-canvas").boundingBox(), box, "the scene keeps its size under the hand");
  await page.mouse.up();
  await until(() => samplesOf(calls).at(-1).name === "pointer_held", "it lets go");
  const samples = samplesOf(calls), held = samples.filter(({name}) => name === "pointer_held").map(({values}) => values[0]);
  assert.deepEqual(held, [1, 0]);
  assert.ok(samples.filter(({name}) => name === "pointer").length >= 8);
  samples.slice(1).forEach(({time}, i) => assert.ok(time >= samples[i].time));
  assert.ok(calls.some(({call}) => call === "clock"), "the clocks are compared");
  assert.equal(calls.filter(({call}) => call === "run.play").length, 1, "a paused run goes on when somebody takes hold");
  assert.match(await text(page, ".scene-words"), /resistance is seen, not felt/i);
}));

test("arrow keys are a hand, Esc and lost focus let go", {skip}, () => withPage(withScene, "scene", {}, async ({page, calls, news}) => {
  news(instant(0, 0));
  await page.locator(".scene-canvas").focus();
  const held = () => samplesOf(calls).filter(({name}) => name === "pointer_held").map(({values}) => values[0]);
  await page.keyboard.down("ArrowRight");
  await until(() => (samplesOf(calls).filter(({name}) => name === "pointer").at(-1)?.values[0] ?? 0) > 0.003, "it moves to the right");
  await page.keyboard.up("ArrowRight");
  await page.keyboard.press("Escape");
  await until(() => held().join() === "1,0", "Esc lets go");
  await page.keyboard.press("ArrowUp", {delay: 100});
  await until(() => held().join() === "1,0,1", "it takes hold again");
  await page.evaluate(() => window.dispatchEvent(new Event("blur")));
  await until(() => held().join() === "1,0,1,0", "lost focus lets go");
}));

test("the stick of a gamepad and a finger are hands", {skip}, () => withPage(withScene, "scene", {hasTouch: true}, async ({page, calls, news}) => {
  news(instant(0, 0));
  const held = () => samplesOf(calls).filter(({name}) => name === "pointer_held").map(({values}) => values[0]);
  await page.evaluate(() => {
    window.pad = {connected: true, axes: [0, -1], buttons: [{pressed: false}, {pressed: false}]};
    navigator.getGamepads = () => [window.pad];
    window.dispatchEvent(new Event("gamepadconnected"));
  });
  await until(() => (samplesOf(calls).filter(({name}) => name === "pointer").at(-1)?.values[1] ?? 0) > 0.001, "the stick up is up");
  await page.evaluate(() => { window.pad = {connected: true, axes: [0, 0], buttons: [{pressed: false}, {pressed: true}]}; });
  await until(() => held().join() === "1,0", "its second button lets go");
  const box = await page.locator(".scene-canvas").boundingBox();
  await page.touchscreen.tap(box.x + 0.75 * box.width, box.y + 0.5 * box.height);
  await until(() => held().join() === "1,0,1,0", "a finger holds while it touches");
  assert.ok(Math.abs(samplesOf(calls).filter(({name}) => name === "pointer").at(-1).values[0] - 0.01) < 2e-4);
}));

test("the scene takes the whole screen and gives it back", {skip}, () => withPage(withScene, "scene", {}, async ({page}) => {
  const width = async () => (await page.locator(".scene-canvas").boundingBox()).width, before = await width();
  await page.getByRole("button", {name: "Full screen"}).click();
  await until(async () => (await width()) > 1.2 * before, "it is larger");
  await page.getByRole("button", {name: "Full screen"}).click();
  await until(async () => (await width()) === before, "it is as before");
}));

test("a hand may stay without a button, and the scene says in words what it shows", {skip}, () => withPage(withScene, "scene", {}, async ({page, calls, news}) => {
  news(instant(0.004, 0));
  await page.getByRole("button", {name: "Hold without a button"}).click();
  await page.locator(".scene-canvas").click();
  await page.waitForTimeout(100);
  assert.deepEqual(samplesOf(calls).filter(({name}) => name === "pointer_held").map(({values}) => values[0]), [1]);
  await page.getByRole("button", {name: "Describe"}).click();
  await until(async () => /ball at 4 mm, 0 mm/.test(await text(page, ".unseen[role=status]")), "it says where the ball is");
}));

const curve = (count) => ({x: Array.from({length: count}, (_, i) => i / count), y: Array.from({length: count}, (_, i) => Math.sin(i / 50))});
const figureOf = (count) => ({width: 680, height: 440, panels: [{panel: "plot", box: [0, 0, 680, 440], x: {label: "time", unit: "s", range: [0, 1]}, y: {label: "position", unit: "mm", range: [-1, 1]},
  marks: [{mark: "line", curves: [curve(count)], line: {color: "#0072B2"}}]}]});

test("figures are drawn again as the run goes on, and not while nobody sees them", {skip}, async () => {
  let asked = 0;
  const answers = {"run.load": () => ({...loaded, figures: 1}), figures: () => ({figures: [figureOf(100 * ++asked)]})};
  await withPage(answers, "figures", {}, async ({page, news}) => {
    await page.waitForSelector(".figure svg");
    assert.match(await page.locator(".figure-sheet").getAttribute("aria-label"), /position \[mm\] from −1 to 1 over time \[s\]/);
    const drawnPoints = () => page.evaluate(() => Math.max(...[...document.querySelectorAll(".figure path")].map((path) => path.getAttribute("d").split("L").length)));
    news({news: "run", run: 1, state: "playing", time: 0.1, tick: 100, rate: 1, wanted: 1, missed: 0, compiled: false, fault: null});
    await until(async () => (await drawnPoints()) >= 300, "it grows");
    await page.locator("#tab-scene").click();
    await page.waitForTimeout(500);
    const before = asked;
    await page.waitForTimeout(1200);
    assert.equal(asked, before);
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

const entries = [{entry: 0, name: "01-first-diagram", title: "A first diagram", group: "Examples"}, {entry: 1, name: "fig38-virtual-environment-inside", title: "Virtual environment", group: "Thesis", caption: "the ball in the ring"}];
const more = async (page, name) => {
  await page.getByRole("button", {name: "More", exact: true}).click();
  await page.getByText(name).click();
};

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
