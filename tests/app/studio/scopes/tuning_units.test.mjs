// Sliders, parameters, signals and layouts, without a browser.

import assert from "node:assert/strict";
import {test} from "node:test";
import {celsius, lists, m, millimetres, near, pinned, samples, tuning} from "./modules.mjs";

test("a slider goes between the bounds of the file, else from nothing to twice the value", () => {
  assert.deepEqual(tuning.sliderRange({low: 0, high: 3, value: 1}), {low: 0, high: 3});
  assert.deepEqual(tuning.sliderRange({low: null, high: null, value: 200}), {low: 0, high: 400});
  assert.deepEqual(tuning.sliderRange({low: null, high: null, value: -2}), {low: -4, high: 0});
  assert.deepEqual(tuning.sliderRange({low: null, high: null, value: 0}), {low: -1, high: 1});
  assert.deepEqual(tuning.sliderRange({low: 1, high: null, value: 2}), {low: 1, high: 4});
  assert.deepEqual(tuning.sliderRange({low: null, high: -1, value: -3}), {low: -6, high: -1});
});

test("places of a slider go over to values and back", () => {
  const range = {low: -0.05, high: 0.05};
  for (const place of [0, 1, 500, 999, 1000]) assert.equal(tuning.placeOf(tuning.valueAt(place, range), range), place);
  assert.equal(tuning.placeOf(9, range), 1000);
});

test("a value is shown in the unit of the file, also a zero and a temperature", () => {
  assert.equal(tuning.valueText(0.0125, millimetres), "12.5 mm");
  assert.equal(tuning.valueText(0, millimetres), "0 mm");
  assert.equal(tuning.valueText(294.15, celsius), "21 degC");
  assert.equal(tuning.valueText(273.15, celsius), "0 degC");
  assert.equal(tuning.valueText(Math.PI / 18, {text: "deg", scale: 180 / Math.PI, offset: 0}), "10 deg");
  assert.equal(tuning.valueText(0.5, {text: "1", scale: 1, offset: 0}), "0.5");
});

test("the history of a run has the values that it began with and those that were set on its way", () => {
  const parameter = (name, text, shown, block = false) => ({name, text, shown, block});
  const kilograms = {text: "kg", scale: 1, offset: 0};
  const all = [parameter("mass", "2 kg", kilograms), parameter("way", "10 mm", millimetres), parameter("c", "3 N", kilograms), parameter("spring.gain", "5 N", kilograms, true)];
  assert.deepEqual(pinned.historyOf(all, [], 0.001), ["mass 2 kg", "way 10 mm"]);
  assert.deepEqual(pinned.historyOf(all, [{tick: 700, name: "mass", text: "3.792"}], 0.001), ["mass 2 kg, then 3.792 kg at 0.7 s", "way 10 mm"]);
  assert.deepEqual(pinned.historyOf(all, [{tick: -1, name: "way", text: "0.02"}, {tick: 500, name: "way", text: "0.03"}, {tick: 600, name: "way", text: "0.04"}, {tick: 2000, name: "way", text: "5 mm"}], 0.001),
    ["way 20 mm, then 30 mm at 0.5 s, then 40 mm at 0.6 s, then 5 mm at 2 s", "mass 2 kg"]);
  assert.deepEqual(pinned.historyOf(all, [{tick: 3, name: "spring.gain", text: "7"}, {tick: 9, name: "push", values: [1]}], 0.001, 1), ["spring.gain 5 N, then 7 kg at 0.003 s", "moved by hand: push"]);
});

test("samples that are missing at the beginning have a first time, others have none", () => {
  assert.equal(m.gapOf(samples([0, 1, 2], [NaN, NaN, 5])), 2);
  assert.equal(m.gapOf(samples([0, 1, 2], [1, NaN, 5])), undefined);
  assert.equal(m.gapOf(samples([0, 1], [NaN, NaN])), 1);
  assert.equal(m.gapOf(undefined), undefined);
});

test("of values that come while one is under way only the last is sent", async () => {
  const sent = [], queue = new tuning.SetQueue(async (value) => {
    sent.push(value);
    await new Promise((resolve) => setTimeout(resolve, 5));
  });
  await Promise.all([queue.put(1), queue.put(2), queue.put(3)]);
  assert.deepEqual(sent, [1, 3]);
});

test("parameters of the file come before those of parts and numbers of blocks; pinned ones first", () => {
  const parameter = (name, block = false) => ({name, doc: "", block});
  const all = [parameter("spring.gain", true), parameter("rig.mass"), parameter("mass"), parameter("gain")];
  assert.deepEqual(tuning.listed(all, "", new Set(["rig.mass"])).map(({name}) => name), ["rig.mass", "mass", "gain", "spring.gain"]);
  assert.deepEqual(tuning.listed(all, "GAIN", new Set()).map(({name}) => name), ["gain", "spring.gain"]);
});

test("a search of signals finds all words of a name, those that begin with it first", () => {
  const columns = ["rig.cart.x", "cart.position", "cart.velocity"].map((name, column) => ({name, column, unit: "m", recorded: true}));
  assert.deepEqual(lists.found(columns, "cart").map(({name}) => name), ["cart.position", "cart.velocity", "rig.cart.x"]);
  assert.deepEqual(lists.found(columns, "cart x").map(({name}) => name), ["rig.cart.x"]);
});

test("a layout comes back from the address of its view; what is none is refused", () => {
  const layout = {version: 1, window: {width: 5, from: null, to: null}, scopes: [{title: "a & b #", traces: [{source: "x in mm", label: "x", unit: millimetres, si: "m", style: 1}]}]};
  const address = lists.addressOf(layout, "http://127.0.0.1:8080/?token=secret#old");
  assert.ok(!address.includes("secret"));
  assert.deepEqual(lists.layoutOfAddress(new URL(address).hash), layout);
  assert.equal(lists.layoutOfAddress("#scopes=%7B"), undefined);
  assert.equal(lists.readLayout({version: 1, scopes: [{title: 3}], window: {width: 1, from: null, to: null}}), undefined);
  assert.equal(lists.readLayout({...layout, window: {width: -1, from: null, to: null}}), undefined);
});

test("ticks of a picture are multiples of 1, 2 or 5", () => {
  const {values, step} = lists.ticksOf({low: -1, high: 1}, 5);
  near(step, 0.5);
  assert.deepEqual(values.map((value) => Number(value.toFixed(6))), [-1, -0.5, 0, 0.5, 1]);
});
