// A table of lines of JSON {workload, by, unit, value, goal} with the machine above it. Exit status 1 for a value beyond `most` times its goal.
// node studio_table.mjs MOST < LINES

import {readFileSync} from "node:fs";
import {cpus, loadavg, release} from "node:os";

const most = Number(process.argv[2]), lines = readFileSync(0, "utf8").trim().split("\n").map((line) => JSON.parse(line));
const exceeds = ({value, goal}) => goal !== undefined && value > goal;

console.log(`${cpus().length} of ${cpus()[0].model.trim()}, Linux ${release()}, load ${loadavg()[0].toFixed(1)}\n`);
console.log("| what | | value | goal |\n|---|---|---|---|");
for (const line of lines) {
  const goal = line.goal === undefined ? "" : `${line.goal} ${line.unit}${exceeds(line) ? ", missed" : ""}`;
  console.log(`| ${line.workload} | ${line.by} | ${line.value} ${line.unit} | ${goal} |`);
}
const wrong = most > 0 ? lines.filter(({value, goal}) => goal !== undefined && value > most * goal) : [];
for (const {workload, by, value, goal, unit} of wrong) console.error(`bench: ${workload}, ${by}: ${value} ${unit} is more than ${most} times ${goal} ${unit}`);
process.exitCode = wrong.length > 0 ? 1 : 0;
