// Draws the graph, the mechanism or the two versions of a graph on the standard input to the standard output. Exit status 3: elkjs is missing.

import {readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {fileURLToPath} from "node:url";
import {setFlagsFromString} from "node:v8";

import {draw, drawCompared, drawRig} from "./draw.mjs";

/**
 * A picture takes seconds, in which most of elk runs too seldom to be worth optimizing: with an interrupt budget 30 times as
 * large as its own, V8 optimizes what is really hot, and a picture takes half to two thirds of the time. An unknown flag is
 * ignored.
 */
setFlagsFromString("--interrupt-budget=2000000");

function fail(status, message) {
  process.stderr.write(`${message}\n`);
  process.exit(status);
}

/** Required, not imported: before an import node would read the whole bundle for names that it exports. */
function newElk() {
  try {
    const ELK = createRequire(import.meta.url)("elkjs/lib/elk.bundled.js");
    return new ELK();
  } catch (error) {
    if (error.code !== "MODULE_NOT_FOUND") throw error;
    return fail(3, `elkjs is not installed; ./stepwire setup in the checkout of ${fileURLToPath(new URL(".", import.meta.url))} installs it`);
  }
}

try {
  const drawn = JSON.parse(readFileSync(0, "utf8"));
  process.stdout.write(drawn.elements ? drawRig(drawn) : drawn.compared ? await drawCompared(drawn.compared, newElk()) : await draw(drawn, newElk()));
} catch (error) {
  fail(1, `the diagram cannot be drawn: ${error.message ?? error}`);
}
