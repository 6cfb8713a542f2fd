// Checks the picture of every diagram file in the folder of diagrams/ that DIAGRAMS names, and of every third one with its parts
// opened, unless it has more than 100 wires then; with OPENED=all of every one. A large picture takes up to a minute.

import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {readdirSync} from "node:fs";
import {join} from "node:path";
import {test} from "node:test";

import {checkApart, checkBlocks, checkDrawnOnce, checkEnds, checkPortOrder, checkTips, checkWhole, checkWires, count, drawing, elk,
        root} from "./picture_checks.mjs";
const {arrange, svgOf} = await import(join(drawing, "draw.mjs"));

const folder = join(root, "diagrams", process.env.DIAGRAMS);
const files = readdirSync(folder).filter((name) => name.endsWith(".yaml")).map((name) => join(folder, name));
assert.ok(files.length > 0, `${folder} has no diagram`);

/** The graph of a file; nothing where its data are not on this machine. */
function graphOf(file, depth) {
  const {status, stdout, stderr} = spawnSync(process.env.STEPWIRE_PROGRAM, ["draw", file, "--json", "--depth", depth]);
  if (status === 3) return undefined;
  assert.equal(status, 0, String(stderr));
  return JSON.parse(stdout);
}

const known = new Map();  // parts that have been laid out, of all files
const closed = new Map();  // the graph of each file, as text

const all = process.env.OPENED === "all", mostWires = 100;
const isOpened = (index) => all || index % 3 === 0;

for (const [index, file] of files.entries())
  for (const depth of isOpened(index) ? [0, 9] : [0])
    test(`${file.slice(root.length + 1)} is drawn well ${depth ? "with its parts opened" : "as it is"}`, async (context) => {
      const graph = graphOf(file, depth);
      if (!graph) return context.skip("its data are not here");
      if (depth && !all && count(graph, "wires") > mostWires) return context.skip("a large picture is checked with OPENED=all");
      const text = JSON.stringify(graph);
      if (closed.get(file) === text) return;  // without parts the same graph has the picture that is checked above
      if (depth === 0) closed.set(file, text);
      const picture = await arrange(graph, elk, known);
      checkBlocks(picture);
      checkWires(picture);
      checkEnds(picture);
      checkWhole(picture);
      checkTips(picture);
      checkPortOrder(picture);
      checkApart(picture);
      assert.equal(picture.wires.filter((wire) => wire.to).length, count(graph, "wires"));
      checkDrawnOnce(svgOf(picture));
      if (depth === 0 && file.includes("/thesis/") && isOpened(index))
        assert.equal(svgOf(picture), svgOf(await arrange(graph, elk)), "drawn twice it differs");
    });
