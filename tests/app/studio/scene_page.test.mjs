// Scene in Chromium, and the source of its hand.

import assert from "node:assert/strict";
import {test} from "node:test";
import {until} from "./browser.mjs";
import {info, instant, loaded, skip, text, withPage, withScene} from "./views_page.mjs";

const samplesOf = (calls) => calls.filter(({call}) => call === "run.input").flatMap(({samples}) => samples);

/** Returns the colour at a position of the scene. */
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
  const held = () => samplesOf(calls).filter(({name}) => name === "pointer_held").map(({values}) => values[0]);
  await until(() => held().length > 0, "a click takes hold");
  await page.waitForTimeout(100);
  assert.deepEqual(held(), [1]);
  await page.getByRole("button", {name: "Describe"}).click();
  await until(async () => /ball at 4 mm, 0 mm/.test(await text(page, ".unseen[role=status]")), "it says where the ball is");
}));

test("who holds an input of a real-time loop says every 0.1 s that it is there, and not afterwards", {skip}, () => {
  const loop = {rate: 1000, period: 1e-3, policy: "other", overrun: "skip"};
  return withPage({...withScene, "run.load": () => ({...loaded, scene: true, stop: null, loop})}, "scene", {}, async ({page, calls}) => {
    const times = () => calls.filter(({call}) => call === "clock").map(({page: at}) => at);
    await until(() => times().length >= 5, "the clocks are compared");
    const before = times().length, {x, y} = await page.locator(".scene-canvas").boundingBox();
    await page.mouse.move(x + 20, y + 20);
    await page.mouse.down();
    await until(() => times().length >= before + 5, "it is said again and again");
    const gaps = times().slice(before + 1).map((at, i) => at - times()[before + i]);
    assert.ok(Math.min(...gaps) < 0.2, `${gaps}`);
    await page.mouse.up();
    await until(() => samplesOf(calls).at(-1).name === "pointer_held", "it lets go");
    const after = times().length;
    await page.waitForTimeout(600);
    assert.ok(times().length <= after + 1);
  });
});
