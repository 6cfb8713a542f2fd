// Draws the graph or mechanism on the standard input to the standard output. Exit status 3: elkjs is missing.

import {readFileSync} from "node:fs";
import {fileURLToPath} from "node:url";

import {draw, drawRig} from "./draw.mjs";

function fail(status, message) {
  process.stderr.write(`${message}\n`);
  process.exit(status);
}

async function newElk() {
  try {
    const {default: ELK} = await import("elkjs/lib/elk.bundled.js");
    return new ELK();
  } catch (error) {
    if (error.code !== "ERR_MODULE_NOT_FOUND") throw error;
    return fail(3, `elkjs is not installed; npm ci in ${fileURLToPath(new URL(".", import.meta.url))} installs it`);
  }
}

try {
  const drawn = JSON.parse(readFileSync(0, "utf8"));
  process.stdout.write(drawn.elements ? drawRig(drawn) : await draw(drawn, await newElk()));
} catch (error) {
  fail(1, `the diagram cannot be drawn: ${error.message ?? error}`);
}
