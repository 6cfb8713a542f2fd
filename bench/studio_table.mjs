// Prints a Markdown table of JSON lines {workload, by, unit, value, goal, isExtreme}, below a line on the machine.
// Usage: node studio_table.mjs MOST LOAD < LINES.
// Exit status 1: a value, unless it is an extreme, exceeds its goal MOST times. Values are not judged if LOAD, the load before the
// measurement, is more than two processes per processor.

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
