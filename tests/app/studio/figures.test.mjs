// Figures in the page are complete: each text, each series, and each point at its position between the axes. The specs are those of the
// examples; STEPWIRE_FIGURES=FOLDER uses all specs in a folder instead.

import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {mkdtempSync, readdirSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {basename, dirname, join, resolve} from "node:path";
import {after, test} from "node:test";
import {fileURLToPath} from "node:url";
import {inflateSync} from "node:zlib";
import {bundled} from "./scopes/bundled.mjs";

const {contrast, dark, describe, light, numberText, pictureOf, reflowed, svgFile, usualStep} =
  await bundled("figures/picture", "figures/svg_painter", "figures/colors", "figures/axis", "figures/description", "figures/reflow");
const root = resolve(dirname(fileURLToPath(import.meta.url)), "../../.."), program = process.env.STEPWIRE_PROGRAM ?? join(root, "build/stepwire");
const drawn = ["01", "11", "20", "27", "29", "33", "36", "40", "41", "42", "43", "44", "82", "88", "92", "99"];

const folders = [];
after(() => folders.forEach((folder) => rmSync(folder, {recursive: true, force: true})));

function outputs() {
  if (process.env.STEPWIRE_FIGURES) return process.env.STEPWIRE_FIGURES;
  const out = mkdtempSync(join(tmpdir(), "figures-")), examples = join(root, "diagrams/examples");
  folders.push(out);
  for (const file of readdirSync(examples).filter((one) => one.endsWith(".yaml") && drawn.includes(one.slice(0, 2)))) {
    const {status, stderr} = spawnSync(program, ["run", join(examples, file), "--out", join(out, basename(file, ".yaml"))], {encoding: "utf8"});
    assert.ok(status === 0 || status === 1, `${file}: ${stderr}`);
  }
  return out;
}

function* figureFiles(folder) {
  for (const entry of readdirSync(folder, {withFileTypes: true}))
    if (entry.isDirectory()) yield* figureFiles(join(folder, entry.name));
    else if (/figure.*\.json$/.test(entry.name)) yield join(folder, entry.name);
}

const figures = [...figureFiles(outputs())].map((path) => ({path, figure: JSON.parse(readFileSync(path, "utf8"))})).filter(({figure}) => Array.isArray(figure.panels));
const svgOf = (figure, isDark = false) => {
  const {width, height, back, marks, front} = pictureOf(figure, isDark);
  return svgFile(width, height, (isDark ? dark : light).paper, [...back, ...marks.flat(), ...front], figure.title ?? "");
};
const plots = figures.flatMap(({path, figure}) => figure.panels.filter(({panel}) => panel === "plot").map((plot) => ({path, plot, svg: svgOf({...figure, panels: [plot]})})));
const unescaped = (text) => text.replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&quot;", '"').replaceAll("&amp;", "&");
const textsOf = (svg) => [...svg.matchAll(/<text[^>]*>([^<]*)<\/text>/g)].map(([, text]) => unescaped(text));
const attribute = (tag, name) => tag.match(new RegExp(` ${name}="([^"]*)"`))?.[1];
const linesOf = (svg, color) => [...svg.matchAll(/<path[^>]*>/g)].map(([tag]) => tag).filter((tag) => attribute(tag, "stroke") === color)
  .map((tag) => attribute(tag, "d").split("M").slice(1).map((line) => line.split("L").map((point) => point.split(" ").map(Number.parseFloat))));
const known = (...columns) => columns[0].map((_, i) => columns.map((column) => column[i])).filter((row) => row.every((value) => value !== null));

test("there are figures of every form", () => {
  const forms = new Set(figures.flatMap(({figure}) => figure.panels.flatMap(({panel, marks = [], view}) => [panel, ...marks.map(({mark}) => mark), ...(view ? ["space"] : [])])));
  for (const form of ["plot", "rig", "scene", "table", "line", "points", "boxes", "rectangles", "image", "vectors", "area", "space"]) assert.ok(forms.has(form), form);
});

test("every figure is drawn, light and dark, and every number in it is finite", () => {
  for (const {path, figure} of figures)
    for (const isDark of [false, true]) {
      const picture = pictureOf(figure, isDark);
      if (picture.kind === "graph") continue;
      const svg = svgOf(figure, isDark);
      assert.doesNotMatch(svg, /NaN|Infinity|undefined/, path);
      assert.ok(svg.length > 200, path);
    }
});

test("every label, legend, title and text of a plot stands in its picture", () => {
  for (const {path, plot, svg} of plots) {
    const texts = textsOf(svg), all = texts.join(" ");
    for (const {label = "", unit = "", named_ticks = []} of [plot.x, plot.y, plot.z, plot.color].filter(Boolean)) {
      if (label || unit) assert.ok(texts.includes(unit ? `${label} [${unit}]` : label), `${path}: ${label}`);
      for (const tick of named_ticks) if (tick.label) assert.ok(texts.includes(tick.label), `${path}: ${tick.label}`);
    }
    if (plot.legend && plot.legend !== "none") for (const {legend} of plot.marks) if (legend) assert.ok(texts.includes(legend), `${path}: ${legend}`);
    for (const {text} of plot.texts ?? []) if (text) assert.ok(texts.includes(text), `${path}: ${text}`);
    for (const word of (plot.title ?? "").split(/\s+/)) assert.ok(all.includes(word), `${path}: ${word}`);
  }
});

test("every point of a line lies where the axes have it", () => {
  let count = 0;
  for (const {path, plot, svg} of plots) {
    if (plot.view || plot.x?.log || plot.y?.log) continue;
    for (const color of new Set(plot.marks.filter(({mark, line}) => mark === "line" && line?.color).map(({line}) => line.color))) {
      const own = plot.marks.filter(({mark, line}) => mark === "line" && line?.color === color);
      if (plot.marks.some((mark) => !own.includes(mark) && (mark.line?.color ?? mark.color) === color)) continue; // strokes of others
      const values = own.flatMap(({curves}) => curves.flatMap(({x, y}) => known(x, y)));
      const drawn = linesOf(svg, color).map((lines) => lines.flat()), all = drawn.find((points) => points.length >= values.length) ? drawn : [drawn.flat()];
      const points = all.flat().slice(0, values.length);
      assert.equal(points.length, values.length, `${path} ${color}`);
      for (const i of [0, 1]) {
        const low = values.reduce((a, b) => (a[i] < b[i] ? a : b)), high = values.reduce((a, b) => (a[i] > b[i] ? a : b));
        const from = points[values.indexOf(low)][i], to = points[values.indexOf(high)][i], scale = high[i] === low[i] ? 0 : (to - from) / (high[i] - low[i]);
        values.forEach((value, k) => assert.ok(Math.abs(points[k][i] - from - scale * (value[i] - low[i])) < 0.02, `${path} ${color} row ${k}`));
        const [first = 0, last = 1] = (i === 0 ? plot.x : plot.y)?.range ?? [];
        assert.ok((i === 0 ? 1 : -1) * Math.sign(last - first) * scale >= 0, `${path} ${color}: x to the right, y upwards`);
      }
      count += values.length;
    }
  }
  assert.ok(count > 1000);
});

test("dots, boxes, bars and strokes are as many as the spec has", () => {
  for (const {path, plot, svg} of plots) {
    if (plot.view) continue;
    const inside = ({range}, value) => !range || (value >= Math.min(...range) && value <= Math.max(...range)), shapes = (svg.match(/Z/g) ?? []).length;
    for (const {mark, rows, symbol} of plot.marks)
      if (mark === "points" && (symbol ?? "disc") !== "asterisk") {
        const count = known(rows.x, rows.y).filter(([x, y]) => inside(plot.x ?? {}, x) && inside(plot.y ?? {}, y)).length;
        assert.ok((svg.match(/<circle/g) ?? []).length >= count, path);
      }
    const needed = plot.marks.reduce((sum, mark) => sum + (mark.mark === "boxes" ? mark.x.length : mark.mark === "rectangles" ? known(mark.x_low, mark.x_high, mark.y_low, mark.y_high).length : 0), 0);
    assert.ok(shapes >= needed, `${path}: ${shapes} of ${needed}`);
  }
});

test("the cells of a map are a PNG with the colours of their values, the lowest row below", () => {
  const mark = {mark: "image", columns: 3, rows: 2, values: [0, 1, 2, 3, null, 5]};
  const svg = svgOf({width: 300, height: 200, panels: [{panel: "plot", box: [0, 0, 300, 200], palette: [{color: "#000000"}, {at: 1, color: "#ffffff"}], color: {range: [0, 5]}, marks: [mark]}]});
  const bytes = Buffer.from(svg.match(/base64,([^"]*)/)[1], "base64"), at = bytes.indexOf("IDAT");
  assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], [3, 2]);
  const raw = inflateSync(bytes.subarray(at + 4, at + 4 + bytes.readUInt32BE(at - 4))), pixel = (row, column) => [...raw.subarray(row * 13 + 1 + 4 * column, row * 13 + 5 + 4 * column)];
  assert.deepEqual(pixel(1, 0), [0, 0, 0, 255]);
  assert.deepEqual(pixel(0, 2), [255, 255, 255, 255]);
  assert.equal(pixel(0, 1)[3], 0, "nothing is drawn where nothing is known");
  assert.ok(pixel(1, 1)[0] < pixel(1, 2)[0] && pixel(1, 2)[0] < pixel(0, 0)[0]);
});

test("bands, shaded ranges, areas and surfaces are drawn, and a gap lifts the pen", () => {
  const x = [0, 1, 2, 3], plot = (marks, more = {}) => svgOf({width: 400, height: 300, panels: [{panel: "plot", box: [0, 0, 400, 300], x: {range: [0, 3]}, y: {range: [0, 9]}, marks, ...more}]});
  assert.match(plot([{mark: "band", x, low: [0, 1, 2, 3], high: [2, 3, 4, 5], color: "#123456"}]), /fill="#123456" fill-opacity="0.2"/);
  assert.match(plot([{mark: "span", low: 1, high: 2, color: "#abcdef"}]), /fill="#abcdef"/);
  assert.match(plot([{mark: "area", x, y: [0, 9, 9, 0], color: "#fedcba"}]), /fill="#fedcba"/);
  const [line] = linesOf(plot([{mark: "line", curves: [{x, y: [1, null, 2, 3]}], line: {color: "#112233", width: 2, dash: [3, 2]}}]), "#112233");
  assert.deepEqual(line.map((points) => points.length), [1, 2]);
  assert.match(plot([{mark: "line", curves: [{x, y: x}], line: {color: "#112233", width: 2, dash: [3, 2]}}]), /stroke-dasharray="6 4"/);
  const rows = (y, z) => ({x, y: [y, y, y, y], z: [z, z + 1, z + 2, z + 3]});
  const surface = plot([{mark: "surface", lines: [rows(0, 0), rows(1, 1), rows(2, 2)]}], {view: {}, z: {label: "up", range: [0, 5]}, color: {range: [0, 5]}, palette: [{color: "#ff0000"}, {at: 1, color: "#ff0000"}]});
  assert.equal(surface.match(/stroke="#ff0000"/g).length, 6, "two strips of three pieces");
});

test("what a diagram says never becomes markup", () => {
  const evil = `"><img src=x onerror=alert(1)>]]>&`, axis = {label: evil, unit: evil, range: [0, 1], named_ticks: [{at: 0.5, label: evil}]};
  const plot = {panel: "plot", box: [0, 0, 400, 300], title: evil, x: axis, y: axis, color: axis, legend: "above", palette: [{color: evil}],
    marks: [{mark: "line", curves: [{x: [0, 1], y: [0, 1]}], line: {color: evil}, legend: evil}, {mark: "area", x: [0, 1], y: [0, 1], color: evil}], texts: [{text: evil, color: evil}]};
  for (const figure of [{title: evil, width: 400, height: 300, panels: [plot]}, {panels: [{panel: "table", title: evil, columns: [evil], rows: [[evil]], notes: [evil]}]},
    {panels: [{panel: "scene", x: [0, 1], y: [0, 1], background: evil, instants: [{words: evil, shapes: [{kind: "text", text: evil, points: [[0, 0]], size: 1, width: 1, color: evil, shown: true}]}]}]}]) {
    const svg = svgOf(figure), tags = new Set([...svg.matchAll(/<\/?([a-zA-Z]+)/g)].map(([, name]) => name));
    assert.ok(!tags.has("img"), svg.slice(0, 300));
    assert.doesNotMatch(svg.replaceAll(/"[^"<>]*"/g, '""').replaceAll(/>[^<>]*</g, "><"), /onerror/);
  }
});

test("on a dark page lines and letters stand out, and colours of values stay", () => {
  for (const {path, figure} of figures) {
    const picture = pictureOf(figure, true);
    if (picture.kind === "graph" || figure.panels[0].panel === "scene") continue;
    for (const {piece, stroke, color, fill} of [...picture.back, ...picture.front]) {
      if (piece === "text") assert.ok(contrast(color, dark.paper) >= 4.5, `${path}: ${color}`);
      if (piece === "path" && stroke && !fill && stroke.color !== dark.grid) assert.ok(contrast(stroke.color, dark.paper) >= 3, `${path}: ${stroke.color}`);
    }
  }
});

test("numbers and ticks are those of gnuplot", () => {
  assert.deepEqual([0, 0.1, -2.5, 1e-5, 1234567, 0.0001, 2e10].map(numberText), ["0", "0.1", "−2.5", "1e−05", "1.23457e+06", "0.0001", "2e+10"]);
  assert.deepEqual([1, 3, 7, 10, 20, 45, 0.3].map(usualStep), [0.2, 0.5, 1, 2, 5, 5, 0.05], "what gnuplot 5.4 takes for plot [0:R]");
});

test("where there is little room panels stand below each other and keep the size of their letters", () => {
  const panel = (left, top) => ({panel: "plot", box: [left, top, 500, 300], title: "t", marks: []}), figure = {width: 1000, height: 630, panels: [panel(0, 30), panel(500, 30), panel(0, 330), panel(500, 330)]};
  const {width, height, panels} = reflowed(figure, 420);
  assert.equal(width, 420);
  assert.deepEqual(panels.map(({box: [left]}) => left), [0, 0, 0, 0]);
  panels.slice(1).forEach(({box: [, top]}, i) => assert.ok(top >= panels[i].box[1] + panels[i].box[3]));
  assert.ok(height >= panels[3].box[1] + panels[3].box[3]);
  assert.equal(reflowed(figure, 950), figure);
  assert.equal(reflowed(figure, 950, 2000), figure);
  const low = reflowed(figure, 950, 100), least = Math.min(...low.panels.map(({box}) => box[3]));
  assert.ok(low.height < figure.height && Math.abs(least - 230) < 1e-9, "a panel is not less high than can be read");
  assert.equal(reflowed(figure, 700).panels[1].box[0], 350);
});

test("each figure has words for who does not see it", () => {
  for (const {path, figure} of figures) {
    const words = describe(figure);
    for (const {x, y} of figure.panels.filter(({panel}) => panel === "plot")) for (const axis of [x, y]) if (axis?.label) assert.ok(words.includes(axis.label), path);
    assert.ok(words.length > 10, path);
  }
});
