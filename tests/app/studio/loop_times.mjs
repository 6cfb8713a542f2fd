// Measures the influence of a page on a real-time loop: the lateness of the wake-up with a stalled page, relative to that without a page.
// Both alternate in one process. Prints lines of JSON with the goal; bench/studio formats them as a table.
// node loop_times.mjs [--rounds 9] [--seconds 5] [--rate 1000] [--short]

import {mkdtempSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {Page, startStudio} from "./raw_page.mjs";
import {hundredSignals} from "./scopes/hundred_signals.mjs";
import {given, print, quantile} from "./times.mjs";

const {rounds, seconds, rate} = given({rounds: [9, 1], seconds: [5, 2], rate: [1000, 1000]});
const sleep = (time) => new Promise((resolve) => setTimeout(resolve, 1000 * time));

const folder = mkdtempSync(join(tmpdir(), "loop-times-"));
const file = join(folder, "hundred.yaml");
writeFileSync(file, hundredSignals());
const {server, address} = await startStudio(folder, "--loop", "--rate", String(rate), file);

/** Runs one loop from its start, and reads its timing at the end. A stalled page is attached before the start. */
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
  await sleep(seconds);
  const looks = await new Page(address).open();
  await looks.call("run.pause");
  const timing = await looks.call("loop");
  looks.close();
  page?.close();
  return timing;
}

const alone = [], watched = [];
await slice(true);  // warm-up
for (let round = 0; round < rounds; ++round) {
  for (const stalled of round % 2 ? [true, false] : [false, true]) (stalled ? watched : alone).push(await slice(stalled));
}
const p999 = (list) => quantile(list.map(({lateness}) => lateness.p999), 0.5);
print("loop, lateness p99.9 without a page", watched[0].policy, "us", 1e6 * p999(alone));
print("loop, lateness p99.9 with a stalled page", watched[0].policy, "us", 1e6 * p999(watched));
print("loop, lateness p99.9 with a stalled page over without", `${rounds} rounds of ${seconds} s`, "ratio", p999(watched) / p999(alone), 1.1, true);
const lost = (list) => list.reduce((sum, one) => sum + one.lost, 0);
print("loop, rows lost with a stalled page", "hub", "rows", lost(watched), 0, lost(alone) > 0);
server.kill("SIGINT");
await new Promise((resolve) => server.on("exit", resolve));
rmSync(folder, {recursive: true});
