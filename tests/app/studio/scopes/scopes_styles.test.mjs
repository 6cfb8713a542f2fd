// Axes and colours of traces, without a browser.

import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {test} from "node:test";
import {m} from "./modules.mjs";

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
