// Frames of samples and their painting, without a browser.

import assert from "node:assert/strict";
import {test} from "node:test";
import {m, near, samples} from "./modules.mjs";

function frameOf(kind, columns) {
  const rows = columns[0].length, message = new ArrayBuffer(32 + 8 * rows * columns.length), header = new DataView(message);
  header.setUint32(0, 0x31445753, true);
  header.setUint8(4, 1);
  header.setUint8(5, kind);
  header.setUint16(6, 7, true);
  header.setUint32(12, rows, true);
  header.setUint16(16, columns.length, true);
  columns.forEach((values, i) => new Float64Array(message, 32 + 8 * rows * i, rows).set(values));
  return m.readFrame(message);
}

test("a frame of samples has one array for a signal, one of extremes two", () => {
  const [a, b] = m.samplesOf(frameOf(0, [[0, 1], [5, 6], [7, 8]]));
  assert.ok(m.isEvery(a));
  assert.deepEqual([...b.high], [7, 8]);
  const [c] = m.samplesOf(frameOf(1, [[0, 1], [-1, -2], [3, 4]]));
  assert.ok(!m.isEvery(c));
  assert.deepEqual([[...c.low], [...c.high]], [[-1, -2], [3, 4]]);
});

test("rows of a window are those inside and one on either side", () => {
  const time = Float64Array.from([0, 1, 2, 3, 4, 5]);
  assert.deepEqual(m.rowsWithin(time, {low: 1.5, high: 3.5}), {from: 1, to: 5});
  assert.equal(m.nearestRow(time, 2.4), 2);
  assert.equal(m.nearestRow(time, 99), 5);
  assert.equal(m.nearestRow(new Float64Array(0), 1), -1);
});

test("the extent of a window leaves out what is no number", () => {
  assert.deepEqual(m.extent(samples([0, 1, 2, 3], [NaN, 2, -1, NaN]), {low: 0, high: 3}), {low: -1, high: 2});
  assert.equal(m.extent(samples([0], [NaN]), {low: 0, high: 1}), undefined);
});

/** Returns a canvas that records only the painted areas. */
function canvas() {
  const bars = [], points = [];
  return {bars, points, lineWidth: 1, setLineDash() {}, beginPath() {}, stroke() {}, translate() {}, arc() {}, fill() {},
    moveTo: (x, y) => points.push([x, y]), lineTo: (x, y) => points.push([x, y]), fillRect: (x, y, w, h) => bars.push([x, y, w, h])};
}
const stroke = {color: "#000", dash: [], alpha: 1, ratio: 1};

test("a peak of one sample among a million is painted to its full height", () => {
  const rows = 1_000_000, time = Float64Array.from({length: rows}, (_, i) => i * 1e-3), values = new Float64Array(rows);
  values[654_321] = 1;
  const context = canvas(), plane = {left: 0, top: 0, width: 300, height: 100, x: {low: 0, high: 1000}, y: {low: 0, high: 1}};
  m.paintOverTime(context, {time, low: values, high: values}, plane, stroke);
  assert.deepEqual(context.bars, []);
  const peak = context.points.filter(([, y]) => y < 99);
  assert.deepEqual(peak, [[Math.floor(0.654321 * 300) + 0.5, 0]]);
});

test("a peak of one sample in sparse extremes is painted, too", () => {
  const context = canvas(), plane = {left: 0, top: 0, width: 300, height: 100, x: {low: 0, high: 10}, y: {low: 0, high: 1}};
  m.paintOverTime(context, {time: Float64Array.from([1, 3, 5]), low: Float64Array.from([0, 0, 0]), high: Float64Array.from([0, 1, 0])}, plane, stroke);
  assert.ok(context.points.some(([x, y]) => x === 90 && y === 0));
});

test("bars of pixels beside each other touch, however rough the curve is", () => {
  const rows = 900, time = Float64Array.from({length: rows}, (_, i) => i), values = Float64Array.from({length: rows}, (_, i) => ((i * 7919) % 101) / 101);
  const context = canvas(), plane = {left: 0, top: 0, width: 300, height: 100, x: {low: 0, high: 900}, y: {low: 0, high: 1}};
  m.paintOverTime(context, {time, low: values, high: values}, plane, stroke);
  assert.equal(context.lineWidth, 1, "each as wide as a pixel");
  const bars = Array.from({length: context.points.length / 2}, (_, i) => [context.points[2 * i], context.points[2 * i + 1]]);
  assert.deepEqual(bars.map(([[x], [sameX]]) => [x, sameX]), Array.from({length: 300}, (_, i) => [i + 0.5, i + 0.5]));
  bars.slice(1).forEach(([[, high], [, low]], i) => assert.ok(high <= bars[i][1][1] && bars[i][0][1] <= low));
});

test("a smooth curve of many rows is one line, which reaches within a pixel of all of them", () => {
  const rows = 30_000, time = Float64Array.from({length: rows}, (_, i) => i), values = time.map((at) => Math.sin(at / 3000));
  const context = canvas(), plane = {left: 0, top: 0, width: 300, height: 100, x: {low: 0, high: rows}, y: {low: -1, high: 1}};
  m.paintOverTime(context, {time, low: values, high: values}, plane, stroke);
  assert.deepEqual(context.bars, []);
  for (const [x, y] of context.points) near(y, 50 - 50 * Math.sin((x * 100) / 3000), 1.5);
});

test("a step of many rows is covered over its whole height", () => {
  const rows = 3000, time = Float64Array.from({length: rows}, (_, i) => i), values = time.map((at) => (at < 1503 ? 0 : 1));
  const context = canvas(), plane = {left: 0, top: 0, width: 300, height: 100, x: {low: 0, high: 3000}, y: {low: 0, high: 1}};
  m.paintOverTime(context, {time, low: values, high: values}, plane, stroke);
  const ys = [...context.points.map(([, y]) => y), ...context.bars.flatMap(([, y, , height]) => [y, y + height])];
  assert.ok(Math.min(...ys) <= 0.5 && Math.max(...ys) >= 99.5);
  assert.ok(context.points.filter(([x]) => x < 150).every(([, y]) => y === 100), "the line stays level up to the step");
});

test("a steep curve that moves has no steps, wherever its rows lie in the pixels", () => {
  const width = 300, height = 200, plane = {left: 0, top: 0, width, height, x: {low: 0, high: 1}, y: {low: -1, high: 1}};
  const value = (time) => Math.sin(2 * Math.PI * 5 * time), yAt = (time) => height / 2 - (height / 2) * value(time);
  for (const [rows, shift] of [[400, 0], [400, 0.0004], [430, 0.0011], [700, 0.0017]]) {
    const time = Array.from({length: rows}, (_, i) => (i + 0.5) / rows + shift), half = 0.5 / rows;
    const ends = time.map((t) => Array.from({length: 9}, (_, k) => value(t - half + (k * half) / 4)));
    const own = {time: Float64Array.from(time), low: Float64Array.from(ends.map((all) => Math.min(...all))), high: Float64Array.from(ends.map((all) => Math.max(...all)))};
    const {points, bars, ...context} = canvas();
    m.paintOverTime({...context}, own, plane, stroke);
    assert.equal(bars.length, 0);
    assert.ok(points.length > 0.9 * Math.min(width, rows));
    for (const [i, [x, y]] of points.entries()) {
      // Distance to the true curve, whose slope is up to 10 pixels per pixel.
      const slope = (Math.PI * 5 * height / width) * Math.cos(2 * Math.PI * 5 * x / width), far = Math.abs(y - yAt(x / width)) / Math.hypot(1, slope);
      assert.ok(far < 0.5, `${rows} rows, point ${i}: ${far}`);
      assert.ok(i === 0 || x > points[i - 1][0], `${rows} rows, point ${i} stands above the one before`);
    }
  }
});
