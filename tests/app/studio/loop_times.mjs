// Does a page disturb a real-time loop? How late a loop wakes with a page attached that has stalled, over how late without: by turns,
// in one run of the program. Prints lines of JSON with the goal; bench/studio makes a table of them.
// node loop_times.mjs [--rounds 9] [--seconds 5] [--rate 1000]

import {mkdtempSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {parseArgs} from "node:util";
import {Page, startStudio} from "./raw_page.mjs";
import {hundredSignals} from "./scopes/hundred_signals.mjs";

const {values} = parseArgs({options: {rounds: {type: "string", default: "9"}, seconds: {type: "string", default: "5"}, rate: {type: "string", default: "1000"}}});
const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
const sleep = (seconds) => new Promise((resolve) => setTimeout(resolve, 1000 * seconds));
const print = (workload, by, unit, value, goal) => console.log(JSON.stringify({workload, by, unit, value: Number(value.toPrecision(3)), goal}));

const folder = mkdtempSync(join(tmpdir(), "loop-times-"));
const file = join(folder, "hundred.yaml");
writeFileSync(file, hundredSignals());
const {server, address} = await startStudio(folder, "--loop", "--rate", values.rate, file);

/** One loop from its start, looked at only at its end. A page that stalls is there before. */
async function slice(stalled) {
  const begins = await new Page(address).open(), {columns} = await begins.call("run.load", {file: 0});
  let page = null;
  if (stalled) {
    page = await new Page(address).open();
    const drawn = columns.slice(0, 20).map(({column}) => column);
    await page.call("data.want", {views: [1, 2, 3, 4, 5, 6].map((view) => ({view, columns: drawn, follow: 60, pixels: 800}))});
    page.stall();
  }
  await begins.call("run.restart");
  await begins.call("run.play", {rate: 1});
  begins.close();
  await sleep(Number(values.seconds));
  const looks = await new Page(address).open();
  await looks.call("run.pause");
  const timing = await looks.call("loop");
  looks.close();
  page?.close();
  return timing;
}

const alone = [], watched = [];
await slice(true);  // not counted
for (let round = 0; round < Number(values.rounds); ++round) {
  for (const stalled of round % 2 ? [true, false] : [false, true]) (stalled ? watched : alone).push(await slice(stalled));
}
const p999 = (list) => median(list.map(({lateness}) => lateness.p999));
print("loop, lateness p99.9 without a page", watched[0].policy, "us", 1e6 * p999(alone));
print("loop, lateness p99.9 with a stalled page", watched[0].policy, "us", 1e6 * p999(watched));
print("loop, lateness p99.9 with a stalled page over without", `${values.rounds} rounds of ${values.seconds} s`, "ratio", p999(watched) / p999(alone), 1.1);
print("loop, rows lost with a stalled page", "hub", "rows", watched.reduce((sum, {lost}) => sum + lost, 0), 0);
server.kill("SIGINT");
await new Promise((resolve) => server.on("exit", resolve));
rmSync(folder, {recursive: true});
