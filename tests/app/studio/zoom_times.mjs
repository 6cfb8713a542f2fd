// Measures the server's time for recorded data: from the request for 20 signals in 6 views to their frames, without a browser. Prints lines
// of JSON with the goal; bench/studio formats them as a table.
// node zoom_times.mjs [--seconds 100] [--short]; --seconds: recorded time of 100 signals at 1 kHz

import {mkdtempSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {Page, startStudio} from "./raw_page.mjs";
import {hundredSignals} from "./scopes/hundred_signals.mjs";
import {given, printQuantiles} from "./times.mjs";

const {seconds} = given({seconds: [100, 20]}), workload = `server: zoom in ${Math.round(seconds * 1e5).toLocaleString("en")} samples`;

const folder = mkdtempSync(join(tmpdir(), "zoom-times-")), file = join(folder, "hundred.yaml");
writeFileSync(file, hundredSignals());
const {server, address} = await startStudio(folder, file), page = await new Page(address).open();
await page.call("run.load", {file: 0});
await page.call("run.seek", {time: seconds});
while ((await page.call("data.statistics", {columns: [0], from: seconds, to: seconds})).statistics[0].last === null) await new Promise((resolve) => setTimeout(resolve, 200));

const counts = [4, 4, 3, 3, 3, 3], first = [], last = [];
let from = 0;
const columns = counts.map((count) => Array.from({length: count}, () => from++));
for (let i = 0; i < 200; ++i) {
  const width = seconds * 2 ** -(i % 8), begin = ((i * 0.618) % 1) * (seconds - width);
  const views = columns.map((of, view) => ({view, columns: of, from: begin, to: begin + width, pixels: 640}));
  const open = new Set(views.map(({view}) => view));
  let sent = 0;
  await new Promise((resolve) => {
    page.onframe = (frame) => {
      if (!open.delete(frame.readUInt16LE(6))) return;
      if (open.size === views.length - 1) first.push(performance.now() - sent);
      page.send(JSON.stringify({ack: frame.readUInt32LE(8)}));
      if (open.size === 0) resolve();
    };
    sent = performance.now();
    page.send(JSON.stringify({call: "data.want", views}));
  });
  last.push(performance.now() - sent);
  await new Promise((resolve) => setTimeout(resolve, 30));
}
printQuantiles(workload, "first view", "ms", first, 5);
printQuantiles(workload, "all 6 views", "ms", last);
page.close();
server.kill("SIGINT");
await new Promise((resolve) => server.on("exit", resolve));
rmSync(folder, {recursive: true});
