// Draws the graph on the standard input to the standard output.

import {readFileSync} from "node:fs";

import {draw} from "./draw.mjs";

async function newElk() {
  try {
    const {default: ELK} = await import("elkjs/lib/elk.bundled.js");
    return new ELK();
  } catch (error) {
    if (error.code !== "ERR_MODULE_NOT_FOUND") throw error;
    process.stderr.write(`elkjs is not installed; 'npm ci' in ${import.meta.dirname} installs it\n`);
    process.exit(3);
  }
}

const graph = JSON.parse(readFileSync(0, "utf8"));
process.stdout.write(await draw(graph, await newElk()));
