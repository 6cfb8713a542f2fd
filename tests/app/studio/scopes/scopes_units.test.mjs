// What scopes, run bar and tuning compute, without a browser: ranges, texts, units, marks, curves.

import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {test} from "node:test";
import {bundled} from "./bundled.mjs";

const m = await bundled("scopes/numbers.ts", "scopes/display_unit.ts", "scopes/y_range.ts", "scopes/time_window.ts", "scopes/samples.ts", "scopes/cursors.ts",
  "scopes/statistics.ts", "scopes/claim_text.ts", "scopes/figure_text.ts", "scopes/yaml_text.ts", "scopes/palette.ts", "scopes/difference.ts", "scopes/trace.ts",
  "scopes/paint.ts", "scopes/axis_group.ts", "run/run_clock.ts", "run/latency.ts", "run/rates.ts", "connection/frame.ts");
const tuning = await bundled("tuning/parameter_range.ts", "tuning/set_queue.ts", "tuning/tuning_list.ts");
const lists = await bundled("scopes/signal_list.ts", "scopes/kept_layout.ts", "scopes/scope_svg.ts");
const millimetres = {text: "mm", scale: 1000, offset: 0}, celsius = {text: "degC", scale: 1, offset: -273.15};
const samples = (time, values) => { const own = Float64Array.from(values); return {time: Float64Array.from(time), low: own, high: own}; };
const near = (a, b, within = 1e-9) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);

test("a number is written with the digits that count and a minus sign", () => {
  assert.equal(m.numberText(49.7712345), "49.771");
  assert.equal(m.numberText(-0.5), "−0.5");
  assert.equal(m.numberText(1.5e-7), "1.5e−7");
  assert.equal(m.numberText(2e9), "2e9");
  assert.equal(m.numberText(100000), "100000");
  assert.equal(m.numberText(NaN), "–");
});

test("labels of an axis have as many decimals as its step, and no minus before a zero", () => {
  assert.equal(m.decimalsOf(0.5), 1);
  assert.equal(m.decimalsOf(2.5), 1);
  assert.equal(m.decimalsOf(0.25), 2);
  assert.equal(m.decimalsOf(20), 0);
  assert.equal(m.decimalsOf(2e-6), 6);
  assert.equal(m.fixedText(-0.0001, 1), "0.0");
  assert.equal(m.fixedText(-12.34, 1), "−12.3");
});

test("a prefix puts the largest magnitude between 1 and 1000", () => {
  assert.deepEqual(m.prefixed("m", 0.04), {text: "mm", scale: 1000, offset: 0});
  assert.deepEqual(m.prefixed("N", 2500), {text: "kN", scale: 1e-3, offset: 0});
  assert.equal(m.prefixed("m/s", 0.002).text, "mm/s");
  assert.equal(m.prefixed("s", 5000).text, "s");
  assert.equal(m.prefixed("kg", 0.001).text, "kg");
  assert.equal(m.prefixed("m^2", 1e-6).text, "m^2");
  assert.equal(m.prefixed("1", 1e-6).text, "1");
  assert.equal(m.prefixed("m", 1).text, "m");
});

test("a value is shown with scale and offset, a slope per second", () => {
  near(m.shownOf(293.15, celsius), 20);
  assert.equal(m.perSecond("N s/m"), "(N s/m)/s");
});

test("a range of values grows at once and shrinks after two seconds", () => {
  const range = new m.YRange();
  range.update({low: 0, high: 1}, 0);
  assert.ok(range.update({low: 0, high: 10}, 0.1).high > 10);
  assert.ok(range.update({low: 0, high: 1}, 0.2).high > 10);
  assert.ok(range.update({low: 0, high: 1}, 2.0).high > 10);
  const shrunk = range.update({low: 0, high: 1}, 2.3);
  assert.ok(shrunk.high < 2 && shrunk.high > 1 && shrunk.low < 0);
});

test("a range chosen by hand stays until it shall fit again", () => {
  const range = new m.YRange();
  range.update({low: 0, high: 1}, 0);
  range.choose({low: -5, high: 5});
  assert.deepEqual(range.update({low: 0, high: 100}, 1), {low: -5, high: 5});
  range.fit();
  assert.ok(range.update({low: 0, high: 100}, 1.1).high > 100);
});

test("a constant has room above and below", () => {
  assert.deepEqual(m.padded({low: 5, high: 5}), {low: 4.5, high: 5.5});
  assert.deepEqual(m.padded({low: 0, high: 0}), {low: -1, high: 1});
  const rounding = m.padded({low: 10 - 1e-12, high: 10 + 1e-12});
  near(rounding.high - rounding.low, 1e-3, 1e-6);
});

test("time follows the newest, and stands still once it is zoomed", () => {
  const window = new m.TimeWindow(10);
  assert.deepEqual(window.at(3), {low: 0, high: 10});
  assert.deepEqual(window.at(25), {low: 15, high: 25});
  window.zoom(0.5, 20, 25);
  assert.equal(window.isFollowing, false);
  assert.deepEqual(window.at(40), {low: 17.5, high: 22.5});
  window.pan(1, 40);
  assert.deepEqual(window.at(40), {low: 22.5, high: 27.5});
  window.follow();
  assert.deepEqual(window.at(40), {low: 30, high: 40});
});

test("the clock of a run goes on between two news of it and never goes back", () => {
  const clock = new m.RunClock();
  clock.observe(0, 1, 0);
  clock.restart(0, 0);
  let last = 0;
  for (let at = 0; at < 2; at += 1 / 60) {
    if (Math.round(at * 60) % 6 === 0) clock.observe(at - 0.004 * (Math.round(at * 60) % 4), 1, at);
    const now = clock.read(at);
    assert.ok(now >= last, `${now} after ${last}`);
    last = now;
    near(now, at, 0.02);
  }
  clock.observe(2, 0, 2);
  assert.equal(clock.read(3), 2);
});

test("the clock of a run does not run away without news", () => {
  const clock = new m.RunClock();
  clock.observe(1, 1, 0);
  for (let at = 0; at < 10; at += 0.1) clock.read(at);
  assert.ok(clock.read(10) < 1.8);
});

test("latency runs from an input to the first picture that has its tick", () => {
  const latency = new m.Latency();
  const acts = latency.sent(100);
  latency.drawn(5, 105);
  acts(5.1);
  latency.drawn(5.05, 110);
  assert.equal(latency.median, undefined);
  latency.drawn(5.2, 118);
  assert.equal(latency.median, 18);
});

test("the pace goes in steps up to as fast as it goes", () => {
  assert.equal(m.nextRate(1, 1), 2);
  assert.equal(m.nextRate(10, 1), 0);
  assert.equal(m.nextRate(0, 1), 0);
  assert.equal(m.nextRate(0.1, -1), 0.1);
  assert.equal(m.rateText(0), "fastest");
});

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

/** A canvas of which only what is covered is kept. */
function canvas() {
  const bars = [], points = [];
  return {bars, points, lineWidth: 1, setLineDash() {}, beginPath() {}, stroke() {}, arc() {}, fill() {},
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
  assert.equal(context.bars.length, 300);
  context.bars.slice(1).forEach(([x, y, , height], i) => {
    const [beforeX, beforeY, beforeWidth, beforeHeight] = context.bars[i];
    assert.equal(x, beforeX + beforeWidth);
    assert.ok(y <= beforeY + beforeHeight && beforeY <= y + height);
  });
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
  assert.equal(m.claimText(measured, "max"), "{that: the greatest cart.position from 1 s to 2.5 s is 50 mm, where: time >= 1 s && time <= 2.5 s, max: cart.position, equals: 50 mm, within: 1 %}");
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

test("traces of one unit share an axis, which keeps its range while others come and go", () => {
  const a = {source: "a", column: 0, label: "a", unit: undefined, si: "m", style: 0}, b = {...a, source: "b", si: "N"}, c = {...a, source: "c"};
  const first = m.grouped([a, b], []);
  first[0].range.update({low: 0, high: 5}, 0);
  const second = m.grouped([a, b, c], first);
  assert.deepEqual(second.map(({traces}) => traces.map(({source}) => source)), [["a", "c"], ["b"]]);
  assert.equal(second[0].range, first[0].range);
});

test("a scope of the file shows its unit; one in SI gets a prefix by size", () => {
  const columns = [{column: 3, name: "cart.position", unit: "m", recorded: true}];
  const inMillimetres = m.traceOf({column: 3, label: "position", unit: "mm", scale: 1000}, columns, 0);
  assert.equal(inMillimetres.source, "cart.position in mm");
  assert.equal(m.unitOf(inMillimetres, 5).text, "mm");
  const inSi = m.traceOf({column: 3, label: "", unit: "m", scale: 1}, columns, 0);
  assert.equal(inSi.source, "cart.position");
  assert.equal(m.unitOf(inSi, 0.02).text, "mm");
});

// Colours: sRGB to Lab, and the matrices of Machado, Oliveira and Fernandes (2009) for full deuteranopia, protanopia and tritanopia.
const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const rgbOf = (text) => [1, 3, 5].map((i) => linear(parseInt(text.slice(i, i + 2), 16) / 255));
const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
const seen = {
  all: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const through = (matrix, rgb) => matrix.map((row) => Math.min(1, Math.max(0, row.reduce((sum, factor, i) => sum + factor * rgb[i], 0))));
function lab([r, g, b]) {
  const f = (t) => (t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 * t + 16) / 116);
  const x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047), y = f(luminance([r, g, b])), z = f((0.0193339 * r + 0.119192 * g + 0.9503041 * b) / 1.08883);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}
const apart = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));
const tokens = readFileSync(new URL("../../../../engine/app/studio/page/src/shell/tokens.css", import.meta.url), "utf8").split("[data-theme");
const token = (text, name) => new RegExp(`--${name}: (#[0-9a-f]{6})`).exec(text)[1];

for (const [theme, text] of [["light", tokens[0]], ["dark", tokens[1]]]) {
  const colors = m.traceColors((name) => token(text, name.slice(2))), surface = luminance(rgbOf(token(text, "surface")));
  test(`traces stand out from the ${theme} page`, () => {
    for (const color of colors) {
      const own = luminance(rgbOf(color)), ratio = (Math.max(own, surface) + 0.05) / (Math.min(own, surface) + 0.05);
      assert.ok(ratio >= 3, `${color}: ${ratio}`);
    }
  });
  for (const [eye, matrix] of Object.entries(seen)) test(`traces stay apart on the ${theme} page: ${eye}`, () => {
    const first = colors.map((color) => lab(through(matrix, rgbOf(color))));
    first.forEach((a, i) => first.slice(0, i).forEach((b, j) => assert.ok(apart(a, b) > 25, `${colors[i]} and ${colors[j]}: ${apart(a, b)}`)));
  });
}

test("twelve traces of a scope have twelve styles", () => {
  const styles = Array.from({length: m.mostTraces}, (_, i) => JSON.stringify(m.traceStyle(i, m.traceColors((name) => name))));
  assert.equal(new Set(styles).size, 12);
  assert.equal(m.freeNumber([0, 1, 3]), 2);
  assert.equal(m.freeNumber(Array.from({length: 12}, (_, i) => i)), undefined);
});

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

test("a parameter is shown in the unit in which it is written", () => {
  assert.deepEqual(tuning.ownUnit({text: "2 kg", value: 2, unit: "kg"}), {text: "kg", scale: 1});
  const unit = tuning.ownUnit({text: "10 mm", value: 0.01, unit: "m"});
  near(unit.scale, 1000, 1e-6);
  assert.equal(tuning.valueText(0.0125, unit), "12.5 mm");
  assert.deepEqual(tuning.ownUnit({text: "2*$mass", value: 4, unit: "kg"}), {text: "kg", scale: 1});
  assert.deepEqual(tuning.ownUnit({text: "0 mm", value: 0, unit: "m"}), {text: "m", scale: 1});
  assert.equal(tuning.valueText(0.5, tuning.ownUnit({text: "0.5", value: 0.5, unit: "1"})), "0.5");
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
