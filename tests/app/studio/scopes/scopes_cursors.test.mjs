// Cursors, statistics, items of claims and figures, and differences of runs, without a browser.

import assert from "node:assert/strict";
import {test} from "node:test";
import {celsius, m, millimetres, near, samples} from "./modules.mjs";

test("cursors stand on ticks; what is between them begins at the earlier one", () => {
  const cursors = new m.Cursors();
  cursors.put("b", 1.0004, 0.001);
  near(cursors.a, 1);
  cursors.put("b", 0.4996, 0.001);
  near(cursors.stretch.low, 0.5);
  near(cursors.distance, -0.5);
  cursors.move("a", 0.001, 0.001, 0);
  near(cursors.a, 1.001);
  cursors.clear();
  assert.equal(cursors.stretch, undefined);
});

const between = {column: 0, min: -0.001, max: 0.05, mean: 0.02, rms: 0.03, slope: 0.1, first: 0.01, last: 0.04};

test("statistics are shown in the unit of their axis, turned where B is before A", () => {
  assert.equal(m.reducedText(between, "max", millimetres), "50 mm");
  assert.equal(m.reducedText(between, "slope", millimetres), "100 mm/s");
  assert.equal(m.reducedText(between, "difference", millimetres), "30 mm");
  assert.equal(m.reducedText(between, "difference", millimetres, true), "−30 mm");
  assert.equal(m.reducedText(between, "a", millimetres, true), "40 mm");
});

test("differences know no offset, and the rms of what is shown is that of shown values", () => {
  const warm = {min: 293.15, max: 303.15, mean: 298.15, rms: Math.sqrt((293.15 ** 2 + 303.15 ** 2) / 2), slope: 1, first: 293.15, last: 303.15};
  near(m.reduced(warm, "difference", celsius), 10);
  near(m.reduced(warm, "rms", celsius), Math.sqrt((20 ** 2 + 30 ** 2) / 2), 1e-6);
});

test("the marks are said with their distance and its inverse", () => {
  assert.equal(m.marksText(1.2, 1.45), "A 1.2 s, B 1.45 s, B − A 250 ms, 1/(B − A) 4 Hz");
  assert.equal(m.marksText(2, undefined), "A 2 s");
  assert.equal(m.marksText(1, 1), "A 1 s, B 1 s, B − A 0 s");
});

test("a number between the cursors becomes a line of claims", () => {
  const measured = {source: "cart.position in mm", label: "cart.position", statistics: between, unit: millimetres, a: 1, b: 2.5};
  assert.equal(m.claimText(measured, "max"), "{that: the maximum of cart.position from 1 s to 2.5 s is 50 mm, where: time >= 1 s && time <= 2.5 s, max: cart.position, equals: 50 mm, within: 1 %}");
  assert.equal(m.claimText(measured, "a"), "{that: cart.position is 10 mm at 1 s, at: {time: 1 s, value: cart.position}, equals: 10 mm, within: 1 %}");
  assert.equal(m.claimText(measured, "slope"), undefined);
  assert.match(m.claimText({...measured, source: "max(a, b)"}, "min"), /min: "max\(a, b\)", equals: -1 mm/);
});

test("a zero is claimed within an absolute bound, as a percent of it is nothing", () => {
  const zero = {source: "a", label: "a", statistics: {...between, min: 0}, unit: millimetres, a: 0, b: 1};
  assert.match(m.claimText(zero, "min"), /equals: 0 mm, within: 0.000001 mm|within: 1e-6 mm/);
});

test("what a label holds does not leave its quotes", () => {
  assert.equal(m.yamlScalar('a: b, "c"'), '"a: b, \\"c\\""');
  assert.equal(m.yamlScalar("x]"), '"x]"');
  assert.equal(m.yamlScalar("true"), '"true"');
  assert.equal(m.yamlScalar("cart.position in mm"), "cart.position in mm");
});

test("scopes are written as figures, with a panel for each unit", () => {
  const trace = (source, unit) => ({source, label: source.split(" ")[0], column: 0, unit, si: "m", style: 0});
  assert.equal(m.figureText("Cart", [[trace("cart.position in mm", millimetres)]]), "{plot: lines, x: time in s, y: cart.position in mm, y_label: cart.position, title: Cart}");
  const two = m.figureText("Both", [[trace("a", undefined), trace("b", undefined)], [trace("f", undefined)]], {low: 1, high: 2});
  assert.equal(two, "{title: Both, columns: 1, panels: [{plot: lines, x: time in s, y: [a, b], legend: [a, b], x_range: [1 s, 2 s]}, {plot: lines, x: time in s, y: f, y_label: f, x_range: [1 s, 2 s]}]}");
  assert.equal(m.figureTextXy("", trace("x", undefined), [trace("y", undefined)]), "{plot: xy, x: x, y: y}");
});

test("equal runs differ nowhere, and a difference beyond the tolerance is found with its time", () => {
  const before = samples([0, 1, 2, 3], [0, 1, 2, 3]);
  assert.equal(m.difference(before, before, 0).worst, 0);
  const found = m.difference(samples([0, 0.5, 1, 2, 3], [0, 0.5, 1, 2.4, 3.1]), before, 0.2);
  near(found.worst, 0.4);
  assert.equal(found.at, 2);
  assert.equal(found.first, 2);
  near(found.share, 0.2);
  assert.equal(m.differenceText(found, 0.2, {text: "m", scale: 1, offset: 0}), "largest difference 0.4 m at 2 s; beyond 0.2 m in 20 % of the time, first at 2 s");
});

test("extremes over the same stretches differ by their ends; over other ones only by what lies outside of both", () => {
  const band = (time, low, high) => ({time: Float64Array.from(time), low: Float64Array.from(low), high: Float64Array.from(high)});
  const before = band([0.5, 1.5], [0, 0], [1, 1]);
  assert.equal(m.difference(band([0.5, 1.5], [0, 0], [1, 3]), before, 0).worst, 2);
  assert.equal(m.difference(samples([0.4, 1.4], [0.5, 1]), before, 0).worst, 0);
  near(m.difference(samples([0.4, 1.4], [0.5, 1.25]), before, 0).worst, 0.25);
});

test("times that only one run has are not compared", () => {
  const found = m.difference(samples([5, 6], [1, 2]), samples([0, 1], [0, 0]), 0);
  assert.match(m.differenceText(found, 0, millimetres), /no time/);
});

test("a tolerance is a value in the shown unit, or a share of the pinned range", () => {
  near(m.readTolerance("0.5", millimetres, 1), 0.0005);
  near(m.readTolerance("0.5 mm", millimetres, 1), 0.0005);
  near(m.readTolerance("2 %", millimetres, 0.05), 0.001);
  assert.equal(m.readTolerance("2 kg", millimetres, 1), undefined);
  assert.equal(m.readTolerance("", millimetres, 1), undefined);
});
