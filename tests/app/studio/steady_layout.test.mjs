// The drawing stays steady while somebody edits: blocks keep their columns.

import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {createRequire} from "node:module";
import {dirname, join} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";
import {kinds} from "./single_edits.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../.."), drawing = join(root, "engine/view/drawing");
const {arrangeLike, arrangeRow} = await import(join(drawing, "draw.mjs")), {columnsOf} = await import(join(drawing, "steady.mjs"));
const elk = new (createRequire(join(drawing, "main.mjs"))("elkjs/lib/elk.bundled.js"))();
const skip = process.env.STEPWIRE_PROGRAM ? false : "STEPWIRE_PROGRAM names the program";
const examples = ["03-parameters", "07-transfer-function", "20-solvers", "22-pid-anti-windup", "31-linkage", "41-loop-and-path", "70-force-feedback", "72-figure-of-eight", "73-safety", "92-loop-margin"];
/** Of each kind of edit so many of an example; STEADY_ALL=1 makes all of them. */
const most = process.env.STEADY_ALL ? Infinity : 6;

function graphOf(name) {
  const {status, stdout, stderr} = spawnSync(process.env.STEPWIRE_PROGRAM, ["draw", join(root, "diagrams/examples", `${name}.yaml`), "--json"], {encoding: "utf8"});
  assert.equal(status, 0, stderr);
  return JSON.parse(stdout);
}

/** The blocks of a picture with their columns, of those that are in both. */
function columnsIn({blocks}, ids) {
  const own = blocks.filter(({id}) => ids.has(id));
  return columnsOf(own, new Map(own.map((block) => [block.id, block])));
}

/** What of a picture changed its column, of the blocks that an edit does not concern. */
function moved(before, after, own) {
  const blocks = ({blocks: all}) => all.filter(({id, within}) => !id.startsWith(":") && !within && !own.includes(id)).map(({id}) => id);
  const ids = new Set(blocks(after).filter((id) => blocks(before).includes(id))), old = columnsIn(before, ids), now = columnsIn(after, ids);
  return {count: ids.size, moved: [...ids].filter((id) => old[id] !== now[id])};
}

const some = (all) => all.filter((_, i) => i % Math.ceil(all.length / Math.min(all.length, most)) === 0);

test("unchanged blocks keep their column in 95 % of single edits", {skip}, async (context) => {
  let edits = 0, kept = 0;
  for (const [kind, make] of Object.entries(kinds)) {
    let ofKind = 0, steady = 0;
    for (const name of examples) {
      const graph = graphOf(name), before = await arrangeRow(graph, elk);
      for (const edit of some([...make(graph)])) {
        const after = await arrangeLike(before.like, edit.graph, elk), found = moved(before, after, edit.own);
        ++ofKind;
        if (found.moved.length === 0) ++steady;
        else if (process.env.STEADY_ALL) console.log(name, edit.what, found.moved.join(" "));
      }
    }
    context.diagnostic(`${kind}: ${steady} of ${ofKind}`);
    edits += ofKind;
    kept += steady;
  }
  context.diagnostic(`in all: ${kept} of ${edits}, ${((100 * kept) / edits).toFixed(1)} %`);
  assert.ok(edits > 200 && kept >= 0.95 * edits, `${kept} of ${edits}`);
});
