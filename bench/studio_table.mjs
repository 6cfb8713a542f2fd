// A table of lines of JSON {workload, by, unit, value, goal, isExtreme} with the machine above it. Exit status 1 for a value beyond `most`
// times its goal that is no extreme.
// node studio_table.mjs MOST LOAD < LINES: where more than two processes for each processor waited before (LOAD), nothing is judged.

import {readFileSync} from "node:fs";
import {cpus, release} from "node:os";

const [most, load] = process.argv.slice(2).map(Number), lines = readFileSync(0, "utf8").trim().split("\n").map((line) => JSON.parse(line));
const isFull = load > 2 * cpus().length;
const exceeds = ({value, goal}) => goal !== undefined && value > goal;

console.log(`${cpus().length} of ${cpus()[0].model.trim()}, Linux ${release()}, load ${load.toFixed(1)} before\n`);
console.log("| what | | value | goal |\n|---|---|---|---|");
for (const line of lines) {
  const goal = line.goal === undefined ? "" : `${line.goal} ${line.unit}${exceeds(line) ? ", missed" : ""}`;
  console.log(`| ${line.workload} | ${line.by} | ${line.value} ${line.unit} | ${goal} |`);
}
if (most > 0 && isFull) console.error("bench: other work fills the machine, so nothing is judged");
const wrong = most > 0 && !isFull ? lines.filter(({value, goal, isExtreme}) => goal !== undefined && !isExtreme && value > most * goal) : [];
for (const {workload, by, value, goal, unit} of wrong) console.error(`bench: ${workload}, ${by}: ${value} ${unit} is more than ${most} times ${goal} ${unit}`);
process.exitCode = wrong.length > 0 ? 1 : 0;
