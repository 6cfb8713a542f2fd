// Measures the memory of the studio during a run in real time: the page's heap after a collection, and the resident memory of the server.
// Of 100 signals at 1 kHz 20 are drawn, in 6 scopes of 60 s. Prints lines of JSON with the goals; bench/studio --long formats them as a
// table.
// node memory.mjs [--minutes 5]

import {readFileSync} from "node:fs";
import {Studio} from "../studio.mjs";
import {given, print} from "../times.mjs";
import {hundredSignals} from "./hundred_signals.mjs";

const {minutes} = given({minutes: [5, 5]});
/** Time after which all buffers are full: 65,536 samples of each signal [s of the run]. */
const filled = 70;
const workload = `run of ${minutes} min in real time, 100 signals at 1 kHz`;

const studio = await Studio.opened(hundredSignals());
try {
  const {page, server} = studio, session = await page.context().newCDPSession(page);
  const heap = async () => {
    await session.send("HeapProfiler.collectGarbage");
    return (await session.send("Runtime.getHeapUsage")).usedSize / 1e6;
  };
  const resident = () => Number(/^VmRSS:\s+(\d+) kB/m.exec(readFileSync(`/proc/${server.pid}/status`, "utf8"))[1]) / 1e3;
  const at = (seconds) => page.waitForFunction((time) => parseFloat(document.querySelector(".run-time").textContent) >= time, seconds, {timeout: 0, polling: 500});
  await page.getByRole("button", {name: "Dismiss"}).click();
  await page.waitForFunction(() => document.querySelectorAll(".scope .trace").length === 20);
  await page.getByLabel("Time span shown").selectOption("60");
  await page.locator(".play").click();
  await at(filled);
  const first = {heap: await heap(), resident: resident()};
  await at(60 * minutes);
  const last = {heap: await heap(), resident: resident()};
  print(workload, "page's heap at the end", "MB", last.heap);
  print(workload, `page's heap, grown since ${filled} s`, "MB", last.heap - first.heap, 5);
  print(workload, "server in memory at the end", "MB", last.resident);
  print(workload, `server in memory, grown since ${filled} s`, "MB", last.resident - first.resident);
} finally {
  await studio.close();
}
