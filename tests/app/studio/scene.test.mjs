// Hand over a scene, descriptions of scenes and mechanisms, the search for examples, and licences.

import assert from "node:assert/strict";
import {existsSync} from "node:fs";
import {dirname, join, resolve} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";
import {bundled} from "./scopes/bundled.mjs";

const {Hand, HandLatency, describeScene, distance, expressionsOf, factsOf, found, isKnown, placed, shapesOf, startOf} =
  await bundled("scene/hand", "scene/hand_latency", "scene/scene_info", "scene/mechanism_model", "gallery/search");
const page = resolve(dirname(fileURLToPath(import.meta.url)), "../../../engine/app/studio/page");
const {licencesOf} = await import(join(page, "src/gallery/licences.mjs"));

const pointer = {name: "pointer", held: "pointer_held", text: ""}, view = {x: [-0.02, 0.02], y: [-0.018, 0.018]};

test("the hand's place comes before its hold, and nothing comes before it is taken", () => {
  const hand = new Hand(pointer, view);
  hand.move(1, [0.001, 0]);
  assert.deepEqual(hand.collect(), []);
  hand.take(2, [0.01, -0.01]);
  hand.move(2.004, [0.011, -0.01]);
  hand.release(2.01);
  hand.move(2.02, [0, 0]);
  assert.deepEqual(hand.collect(), [
    {time: 2, name: "pointer", values: [0.01, -0.01]}, {time: 2, name: "pointer_held", values: [1]}, {time: 2.004, name: "pointer", values: [0.011, -0.01]},
    {time: 2.01, name: "pointer_held", values: [0]}]);
  assert.deepEqual(hand.collect(), [], "each sample is sent once");
});

test("the hand stays in the view, and its clock never goes back", () => {
  const hand = new Hand(pointer, view);
  hand.take(5, [1, -1]);
  hand.move(4.9, [0, 0]);
  hand.take(5.1, [0, 0]);
  const samples = hand.collect();
  assert.deepEqual(samples[0].values, [0.02, -0.018]);
  assert.deepEqual(samples.map(({time}) => time), [5, 5, 5, 5.1]);
  assert.equal(samples.filter(({name}) => name === "pointer_held").length, 1, "who holds already does not take hold again");
});

test("a page that cannot send keeps the newest samples only", () => {
  const hand = new Hand(pointer, view);
  hand.take(0, [0, 0]);
  for (let i = 1; i <= 5000; ++i) hand.move(i / 1000, [0, 0]);
  const samples = hand.collect();
  assert.ok(samples.length <= 2000);
  assert.equal(samples[samples.length - 1].time, 5);
});

test("the latency counts each sample once, and only what was sent", () => {
  const latency = new HandLatency();
  latency.drawn({input: 1}, 9);
  assert.equal(latency.median, undefined);
  latency.sent([{time: 1}, {time: 1.002}]);
  latency.drawn({input: 1.002}, 1.012);
  latency.drawn({input: 1.002}, 1.5);
  latency.drawn({input: 1.001}, 1.55); // of another page
  latency.drawn({input: null}, 1.6);
  assert.ok(Math.abs(latency.median - 0.01) < 1e-9);
});

const info = {...view, background: "dark", pointer, objects: [
  {name: "walls", kind: "walls", walls: [{points: [[0, 0], [0.01, 0], [0.01, 0.01]], closed: true}, {points: [[0, 0], [1, 1]], closed: false}]},
  {name: "goal", kind: "point"}, {name: "pen", kind: "ball"}, {name: "hint", kind: "text", text: "Follow the line"}]};
const base = {size: 0.001, width: 0.0005, shown: true};
const news = {time: 1.5, shapes: [
  {...base, object: 0, wall: 0, points: [], color: "#2b83ff"}, {...base, object: 0, wall: 1, points: [], color: "#ff0000", crossed: true},
  {...base, object: 1, points: [[0.001, 0.002]], color: "#00ffff"}, {...base, object: 2, points: [[-0.003, 0.004]], color: "#ffff00"},
  {...base, object: 3, points: [[0, 0.015]], color: "#ffffff", shown: false}, {...base, object: 9, points: [[0, 0]], color: "#ffffff"}]};

test("walls have the points of the scene, all else those of the instant; what is not in the scene is left out", () => {
  const shapes = shapesOf(info, news);
  assert.deepEqual(shapes.map(({kind}) => kind), ["walls", "walls", "point", "ball", "text"]);
  assert.deepEqual(shapes[0].points, info.objects[0].walls[0].points);
  assert.equal(shapes[1].closed, false);
  assert.deepEqual(shapes[3].points, [[-0.003, 0.004]]);
  assert.equal(shapes[4].text, "Follow the line");
});

test("a scene says in words where things are, and which wall is crossed", () => {
  const words = describeScene(info, news);
  assert.match(words, /at 1\.50 s/);
  assert.match(words, /pen at −3 mm, 4 mm/);
  assert.match(words, /wall 2 of walls is crossed/);
  assert.doesNotMatch(words, /Follow/, "what is hidden is not said");
});

test("a hand that has no place yet begins at the ball, else in the middle", () => {
  assert.deepEqual(startOf(info, news), [-0.003, 0.004]);
  assert.deepEqual(startOf(info, undefined), [0, 0]);
});

const rig = {title: "platform", dimensions: 3, elements: [
  {kind: "damper", name: "left MR damper", points: [[0, 0.3, 0], ["p.1", "p.2", "p.3"]]}, {kind: "universal", points: [[0, 0.3, 0]]},
  {kind: "end_effector", name: "F_e", points: [["p.1", "p.2", "p.3"]]}, {kind: "damper", points: [[0, 0, 0], ["q", 0]]}]};

test("a mechanism asks for each signal once and stands where they are", () => {
  assert.deepEqual(expressionsOf(rig), ["p.1", "p.2", "p.3", "q"]);
  const all = placed(rig, new Map([["p.1", 0], ["p.2", 0.1], ["p.3", 0]]));
  assert.deepEqual(all[0].points, [[0, 0.3, 0], [0, 0.1, 0]]);
  assert.ok(Math.abs(distance(...all[0].points) - 0.2) < 1e-12);
  assert.ok(!isKnown(all[3]), "a signal without a value has no place");
  assert.deepEqual(factsOf(rig, all), [{name: "left MR damper", value: "200 mm long"}, {name: "F e", value: "x 0 mm, y 100 mm, z 0 mm"}]);
});

test("examples are found by words, numbers of figures and captions, the best first", () => {
  const entries = [
    {entry: 0, name: "01-first-diagram", title: "A first diagram", group: "Examples"}, {entry: 1, name: "29-mr-damper", title: "A damper", group: "Examples", caption: "with a spring"},
    {entry: 2, name: "fig03-planar-interface", title: "Interface", group: "Thesis", caption: "two dampers"}, {entry: 3, name: "fig38-virtual-environment-inside", title: "Virtual environment", group: "Thesis"}];
  const names = (query) => found(entries, query).map(({entry}) => entry);
  assert.deepEqual(names(""), [0, 1, 2, 3]);
  assert.deepEqual(names("figure 38"), [3]);
  assert.deepEqual(names("Fig. 3"), [2]);
  assert.deepEqual(names("damper"), [1, 2]);
  assert.deepEqual(names("damper spring"), [1]);
  assert.deepEqual(names("nothing of it"), []);
});

test("every package of the page has a licence and its text", (t) => {
  if (!existsSync(join(page, "node_modules"))) return t.skip("npm ci was not run in the page's folder");
  const all = licencesOf(page);
  for (const name of ["three", "uplot", "elkjs", "@codemirror/view", "@lezer/common"]) assert.ok(all.some((one) => one.name === name), name);
  for (const {name, version, licence, text} of all) {
    assert.match(licence, /^(MIT|ISC|BSD|Apache|EPL-2\.0)/, `${name}: ${licence}`);
    assert.match(version, /^\d/, name);
    assert.ok(text.length > 500, name);
  }
});
