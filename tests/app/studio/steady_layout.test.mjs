// The drawing is stable during editing: blocks keep their columns.

import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {createRequire} from "node:module";
import {dirname, join} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";
import {kinds} from "./single_edits.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../.."), drawing = join(root, "engine/view/drawing");
const {arrangeLike, arrangeRow, relabeled} = await import(join(drawing, "draw.mjs")), {columnsOf} = await import(join(drawing, "steady.mjs"));
const elk = new (createRequire(join(drawing, "main.mjs"))("elkjs/lib/elk.bundled.js"))();
const skip = process.env.STEPWIRE_PROGRAM ? false : "STEPWIRE_PROGRAM names the program";
const examples = ["03-parameters", "07-transfer-function", "20-solvers", "22-pid-anti-windup", "31-linkage", "41-loop-and-path", "70-force-feedback", "72-figure-of-eight", "73-safety", "92-loop-margin"];
/** Number of edits of each kind per example; STEADY_ALL=1 makes all of them. */
const most = process.env.STEADY_ALL ? Infinity : 4;

function graphOf(name) {
  const {status, stdout, stderr} = spawnSync(process.env.STEPWIRE_PROGRAM, ["draw", join(root, "diagrams/examples", `${name}.yaml`), "--json"], {encoding: "utf8"});
  assert.equal(status, 0, stderr);
  return JSON.parse(stdout);
}

/** Returns the columns of the blocks `ids` in a picture. */
function columnsIn({blocks}, ids) {
  const own = blocks.filter(({id}) => ids.has(id));
  return columnsOf(own, new Map(own.map((block) => [block.id, block])));
}

/** Returns the blocks that an edit does not affect but that have changed their column. */
function moved(before, after, own) {
  const blocks = ({blocks: all}) => all.filter(({id, within}) => !id.startsWith(":") && !within && !own.includes(id)).map(({id}) => id);
  const ids = new Set(blocks(after).filter((id) => blocks(before).includes(id))), old = columnsIn(before, ids), now = columnsIn(after, ids);
  return {count: ids.size, moved: [...ids].filter((id) => old[id] !== now[id])};
}

const some = (all) => all.filter((_, i) => i % Math.ceil(all.length / Math.min(all.length, most)) === 0);

test("unchanged blocks keep their column in 95 % of single edits", {skip}, async (context) => {
  let edits = 0, kept = 0;
  const drawn = await Promise.all(examples.map(async (name) => {
    const graph = graphOf(name);
    return {name, graph, before: await arrangeRow(graph, elk)};
  }));
  for (const [kind, make] of Object.entries(kinds)) {
    let ofKind = 0, steady = 0;
    for (const {name, graph, before} of drawn)
      for (const edit of some([...make(graph)])) {
        const after = await arrangeLike(before.like, edit.graph, elk), found = moved(before, after, edit.own);
        ++ofKind;
        if (found.moved.length === 0) ++steady;
        else if (process.env.STEADY_ALL) console.log(name, edit.what, found.moved.join(" "));
      }
    context.diagnostic(`${kind}: ${steady} of ${ofKind}`);
    edits += ofKind;
    kept += steady;
  }
  context.diagnostic(`in all: ${kept} of ${edits}, ${((100 * kept) / edits).toFixed(1)} %`);
  assert.ok(edits > 100 && kept >= 0.95 * edits, `${kept} of ${edits}`);
});

test("an edit of a number or a name moves nothing and needs no layout", {skip}, async () => {
  for (const name of examples.slice(0, 5)) {
    const graph = graphOf(name), picture = await arrangeRow(graph, elk), i = graph.nodes.findIndex(({outline, lines}) => outline !== "circle" && lines.length > 0), {id} = graph.nodes[i];
    const other = `${id.slice(0, -1)}q`, rename = (end) => (end.node === id ? {...end, node: other} : end);
    const edited = {
      ...graph, nodes: graph.nodes.map((node, k) => (k === i ? {...node, id: other, name: node.name && other, lines: node.lines.map((line) => line.replaceAll(/\d/g, "7"))} : node)),
      wires: graph.wires.map((wire) => ({...wire, from: rename(wire.from), to: rename(wire.to)})),
    };
    const after = relabeled({graph, picture}, edited), places = ({blocks}) => blocks.map(({x, y, height}) => [x, y, height]);
    assert.ok(after, name);
    assert.deepEqual(places(after), places(picture));
    assert.deepEqual(after.wires.map(({points}) => points), picture.wires.map(({points}) => points));
    assert.ok(after.blocks.some((block) => block.id === other) && !after.blocks.some((block) => block.id === id));
    assert.ok(other in after.like.columns);
  }
});

test("a block that becomes a little wider grows in its place, with its wires; one that has no room there is laid out", {skip}, async () => {
  const graph = graphOf(examples[0]), picture = await arrangeRow(graph, elk), i = graph.nodes.findIndex(({outline}) => outline === "box");
  const lines = (...all) => ({...graph, nodes: graph.nodes.map((node, k) => (k === i ? {...node, lines: all} : node))});
  const {id, x, width} = picture.blocks.find((block) => block.id === graph.nodes[i].id);
  for (let letters = 1; letters < 40; ++letters) {
    const after = relabeled({graph, picture}, lines("m".repeat(letters)));
    if (!after) return assert.ok(letters > 2);
    const block = after.blocks.find((one) => one.id === id), ends = after.wires.filter(({to}) => to?.node === id).map(({points}) => points.at(-1)[0]);
    assert.ok(block.width <= width + 20 && block.x >= x - 10);
    assert.ok(ends.every((end) => end === block.x || end === block.x + block.width));
  }
  assert.fail("a block of 40 letters has no room");
});
