// Checks of the picture of a mechanism.

import assert from "node:assert/strict";
import {dirname, join} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../../..");
const {arrangeRig, drawRig} = await import(join(root, "engine/view/drawing/draw.mjs"));
const {widthOf} = await import(join(root, "engine/view/drawing/text.mjs"));

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
  for (const kind of ["damper", "motor", "spring", "rod", "dashpot", "bouc_wen", "potentiometer", "lvdt", "load_cell", "arrow", "force", "motion",
    "torque", "axis", "dimension", "ground", "universal", "pin", "end_effector", "carriage", "shaker", "slide", "rotary_damper", "box", "wall", "base",
    "workspace", "path"]) {
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

const names = (rig) => Object.fromEntries(arrangeRig(rig).names.map((one) => [one.name, one]));
const far = ([x, y], [[ax, ay], [bx, by]]) => {
  const share = Math.min(1, Math.max(0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)));
  return Math.hypot(x - ax - share * (bx - ax), y - ay - share * (by - ay));
};

test("between two links close to each other each name is nearer to its own", () => {
  const elements = [
    {kind: "base", points: [[-0.2, 0.4], [0.2, 0.4], [0, -0.04]], name: "base"},
    {kind: "damper", points: [[-0.1584, 0.3584], [0, 0.18]], name: "left MR damper", body: 0.13},
    {kind: "damper", points: [[0.1584, 0.3584], [0, 0.18]], name: "right MR damper", body: 0.13},
    {kind: "motor", points: [[0, 0], [0, 0.18]], name: "linear motor", body: 0.11},
    {kind: "potentiometer", points: [[-0.1584, 0.3584], [0, 0.18]], name: "string potentiometer"},
    {kind: "potentiometer", points: [[0.1584, 0.3584], [0, 0.18]], name: "other potentiometer"},
    {kind: "ground", points: [[-0.1584, 0.3584], [0.1584, 0.3584], [0, 0]]},
    {kind: "force", points: [[0, 0.18]], direction: [0.5, -0.87], name: "F_e"},
  ];
  const {names: placed, placed: bodies} = arrangeRig({title: "", dimensions: 2, elements});
  assert.ok(placed.every(({isFree}) => isFree));
  const link = (name) => bodies.find((one) => one.name === name).at;
  for (const [own, other] of [["left MR damper", "right MR damper"], ["right MR damper", "left MR damper"]]) {
    const {left, right, top, bottom} = boxOf(placed.find(({name}) => name === own)), middle = [(left + right) / 2, (top + bottom) / 2];
    assert.ok(far(middle, link(own)) < far(middle, link(other)), own);
  }
});

test("names of two links that are mirror images are at mirrored places, apart from each other", () => {
  const pin = [0, 0.18], links = ["damper", "potentiometer"].flatMap((kind) => [[-0.1584, "left"], [0.1584, "right"]].map(([x, side]) =>
    ({kind, points: [[x, 0.3584], pin], name: kind === "damper" ? `${side} damper` : "string potentiometer"})));
  const motor = {kind: "motor", points: [[0, 0], pin], name: "linear motor"};
  const base = {kind: "base", points: [[-0.215, 0.395], [0.215, 0.395], [0, -0.06]], name: "base"};
  const {names, paper} = arrangeRig({title: "mirrored", dimensions: 2, elements: [...links, motor, base]}), [middle] = paper.place([0, 0]);
  for (const i of [0, 2]) {
    const left = boxOf(names[i]), right = boxOf(names[i + 1]);
    assert.ok(Math.abs(left.top - right.top) < 1e-9, "on one line");
    assert.ok(left.right + 20 < right.left, "with a space between");
    assert.ok(Math.abs(names[i].at[0] + names[i + 1].at[0] - 2 * middle) < 1e-9, "as far from the middle");
  }
});

test("a force points where it is said to, from its point, and lies on the page with its name", () => {
  for (const degrees of [0, 60, 90, 200, 300]) {
    const direction = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
    const rig = {title: "", dimensions: 2, elements: [{kind: "pin", points: [[0, 0]]}, {kind: "rod", points: [[0, 0], [0.1, 0]]}, {kind: "force", points: [[0, 0]], direction, name: "F_e"}]};
    const [, x0, y0, x1, y1] = drawRig(rig).match(/M([\d.]+) ([\d.]+)L([\d.]+) ([\d.]+)" stroke="#b03020"/).map(Number), {paper, placed} = arrangeRig(rig);
    assert.ok(Math.abs(Math.atan2(y0 - y1, x1 - x0) - Math.atan2(direction[1], direction[0])) < 0.01, `${degrees} degrees`);
    assert.ok(distance([x0, y0], placed[0].at[0]) < 15);
    assert.ok(x1 > 0 && y1 > 0 && x1 < paper.width && y1 < paper.height);
    const {left, right, top, bottom} = boxOf(names(rig)["F_e"]);
    assert.ok(left > 0 && top > 0 && right < paper.width && bottom < paper.height);
  }
});

test("z may point upwards, and axes have the names that they are given", () => {
  const rig = {...space, up: "z", axes: ["x", "y", "r"]}, {paper} = arrangeRig(rig);
  const [from, to] = [paper.place([0, 0, 0]), paper.place([0, 0, 0.1])];
  assert.ok(to[1] < from[1] - 10 && Math.abs(to[0] - from[0]) < 1e-9);
  assert.match(drawRig(rig), />r<\/text>/);
  assert.ok(!/mm<\/text>/.test(drawRig({...plane, schematic: true, elements: plane.elements.slice(0, 7)})), "a schematic has no scale");
});

test("a universal joint does not look like a pin joint", () => {
  const rig = (kind) => drawRig({title: "", dimensions: 2, elements: [{kind, points: [[0, 0]]}, {kind: "rod", points: [[0, 0], [0.1, 0]]}]});
  const lines = (svg) => svg.match(/<path/g).length;
  assert.equal(lines(rig("universal")), lines(rig("ground")) + 2);
});

test("a name stands in its box where it fits, else beside it", () => {
  const rig = (name) => ({title: "", dimensions: 2, elements: [{kind: "box", points: [[0, 0], [0.05, 0.1]], name}, {kind: "wall", points: [[-0.2, 0], [0.2, 0]]}]});
  assert.equal(arrangeRig(rig("m")).names.length, 0);
  assert.match(drawRig(rig("m")), />m<\/text>/);
  assert.equal(arrangeRig(rig("the whole of the moving mass of it")).names.length, 1);
});

test("a shaker stands behind the point that it moves, whatever its direction", () => {
  const heads = [[0, 0], [0.2, 0.2]], link = {kind: "rod", points: heads};
  const body = (direction) => {
    const rig = {title: "", dimensions: 2, elements: [link, {kind: "shaker", points: [[0, 0]], direction}]};
    const [x, y] = arrangeRig(rig).placed[1].at[0];
    const box = drawRig(rig).match(/<path d="([^"]*)" fill="#e6ecf3"/) ?? drawRig(rig).match(/<polygon points="([^"]*)" fill="#e6ecf3"/);
    const numbers = [...box[1].matchAll(/-?[\d.]+/g)].map(Number), pick = (k) => numbers.filter((_, i) => i % 2 === k);
    return {left: Math.max(...pick(0)) - x, below: Math.min(...pick(1)) - y};
  };
  assert.ok(body(undefined).left < -10);
  assert.ok(body([0, 1]).below > 10);
});
