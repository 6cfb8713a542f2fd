// What holds for the picture of a mechanism.

import assert from "node:assert/strict";
import {dirname, join} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");
const {arrangeRig, drawRig} = await import(join(root, "engine/draw/draw.mjs"));
const {widthOf} = await import(join(root, "engine/draw/text.mjs"));

const plane = {
  title: "a rig", dimensions: 2,
  elements: [
    {kind: "workspace", points: [[-0.02, 0.18], [0.02, 0.22]], name: "workspace"},
    {kind: "damper", points: [[-0.1584, 0.3584], [0, 0.2]], name: "left damper", body: 0.13},
    {kind: "damper", points: [[0.1584, 0.3584], [0, 0.2]], name: "right damper", body: 0.13},
    {kind: "potentiometer", points: [[-0.1584, 0.3584], [0, 0.2]], name: "string potentiometer"},
    {kind: "motor", points: [[0, 0], [0, 0.2]], name: "linear motor"},
    {kind: "ground", points: [[-0.1584, 0.3584], [0.1584, 0.3584], [0, 0]]},
    {kind: "end_effector", points: [[0, 0.2]], name: "end-effector"},
    {kind: "dimension", points: [[-0.1584, 0.3584], [0.1584, 0.3584]], offset: 0.035},
  ],
};
const space = {
  title: "in space", dimensions: 3,
  elements: [
    {kind: "damper", points: [[-0.1584, 0.3584, 0], [0, 0.2, 0]], name: "left damper"},
    {kind: "damper", points: [[0.1584, 0.3584, 0], [0, 0.2, 0]], name: "right damper"},
    {kind: "damper", points: [[0, 0.2, 0.224], [0, 0.2, 0]], name: "third damper"},
    {kind: "workspace", points: [[-0.02, 0.18, -0.02], [0.02, 0.22, 0.02]], name: "workspace"},
    {kind: "end_effector", points: [[0, 0.2, 0]], name: "end-effector"},
    {kind: "dimension", points: [[0, 0.2, 0], [0, 0.2, 0.224]], offset: 0.05},
  ],
};
const distance = ([ax, ay], [bx, by]) => Math.hypot(ax - bx, ay - by);
const boxOf = ({name, at: [x, y], anchor}) => {
  const width = widthOf(name, 12), left = anchor === "start" ? x : anchor === "end" ? x - width : x - width / 2;
  return {left, right: left + width, top: y - 6, bottom: y + 6};
};

test("a rig in the plane is to scale, x to the right and y upwards", () => {
  const {paper, placed} = arrangeRig(plane);
  for (const {points, at} of placed)
    for (let i = 1; i < points.length; ++i)
      assert.ok(Math.abs(distance(at[0], at[i]) - 1000 * paper.scale * distance(points[0], points[i])) < 1e-9);
  const [left, right, base] = placed[5].at;
  assert.ok(left[0] < right[0] && Math.abs(left[1] - right[1]) < 1e-9 && base[1] > left[1]);
});

test("in space what is parallel stays so, and no two dampers of the platform cover each other", () => {
  const {paper} = arrangeRig(space), at = (...point) => paper.place(point);
  const along = (from, to) => [to[0] - from[0], to[1] - from[1]];
  const [a, b] = [along(at(0, 0, 0), at(0.1, 0.2, 0.3)), along(at(1, 2, 3), at(1.1, 2.2, 3.3))];
  assert.ok(Math.abs(a[0] - b[0]) < 1e-9 && Math.abs(a[1] - b[1]) < 1e-9);
  const pin = at(0, 0.2, 0), angles = [[-0.1584, 0.3584, 0], [0.1584, 0.3584, 0], [0, 0.2, 0.224]]
    .map((anchor) => along(pin, at(...anchor))).map(([x, y]) => (Math.atan2(y, x) * 180) / Math.PI);
  angles.forEach((one, i) => angles.slice(0, i).forEach((other) => {
    const apart = Math.abs(one - other) % 180;
    assert.ok(Math.min(apart, 180 - apart) > 15, `${one} and ${other} degrees`);
  }));
});

for (const rig of [plane, space])
  test(`names cover neither each other nor a link: ${rig.title}`, () => {
    const {names, placed, paper} = arrangeRig(rig), boxes = names.map(boxOf);
    assert.equal(names.length, rig.elements.filter(({name}) => name).length);
    boxes.forEach((box, i) => {
      assert.ok(box.left >= 0 && box.right <= paper.width && box.top >= 0 && box.bottom <= paper.height);
      for (const other of boxes.slice(0, i))
        assert.ok(box.right < other.left || other.right < box.left || box.bottom < other.top || other.bottom < box.top);
      for (const {kind, at: [from, to]} of placed.filter((one) => ["damper", "motor"].includes(one.kind)))
        for (let share = 0; share <= 1; share += 0.01) {
          const [x, y] = [0, 1].map((k) => from[k] + share * (to[k] - from[k]));
          assert.ok(x < box.left - 4 || x > box.right + 4 || y < box.top - 4 || y > box.bottom + 4, `${names[i].name} on a ${kind}`);
        }
    });
  });

test("a dimension says the true distance, also of what is seen aslant", () => {
  assert.match(drawRig(plane), />316.8 mm</);
  assert.match(drawRig(space), />224 mm</);
});

test("every kind of element is drawn, the same bytes each time, and its name escaped", () => {
  const ends = [[0, 0], [0.2, 0.1]];
  for (const kind of ["damper", "motor", "spring", "rod", "potentiometer", "lvdt", "load_cell", "arrow", "dimension", "ground", "pin",
    "end_effector", "carriage", "shaker", "rotary_damper", "workspace", "path"]) {
    const one = {kind, points: ends, name: "<&>"}, empty = {title: "", dimensions: 2, elements: [{kind: "path", points: ends}]};
    const drawn = drawRig({title: "", dimensions: 2, elements: [one]});
    assert.equal(drawn, drawRig({title: "", dimensions: 2, elements: [one]}));
    assert.ok(drawn.length > drawRig(empty).length || kind === "path", kind);
    assert.ok(!/NaN|undefined|Infinity/.test(drawn), kind);
    if (kind !== "dimension") assert.match(drawn, />&lt;&amp;&gt;</, kind);
  }
});

test("the lines to what a dimension measures begin beside the joints there", () => {
  const elements = [{kind: "ground", points: [[0, 0], [0.2, 0]]}, {kind: "dimension", points: [[0, 0], [0.2, 0]], offset: 0.1}];
  const {placed} = arrangeRig({title: "", dimensions: 2, elements}), drawn = drawRig({title: "", dimensions: 2, elements});
  const starts = [...drawn.matchAll(/<path d="M([\d.]+) ([\d.]+)L[^"]*" stroke="#9a9a9a"\/>/g)].map(([, x, y]) => [Number(x), Number(y)]);
  assert.equal(starts.length, 2);
  starts.forEach((start, i) => assert.ok(distance(start, placed[0].at[i]) > 21, "it runs through the hatching"));
});
