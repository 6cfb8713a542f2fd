// What a picture of the scopes costs: 100 signals at 1 kHz, 20 of them drawn in 6 scopes, of the newest 60 s. Prints a line of JSON.
// node frame_times.mjs [--seconds N] [--address URL of a studio's page]

import {existsSync} from "node:fs";
import {parseArgs} from "node:util";
import {served} from "./bundled.mjs";

const {values} = parseArgs({options: {seconds: {type: "string", default: "20"}}});
const playwright = (await import("playwright-core")).default;
const executablePath = [process.env.STEPWIRE_CHROMIUM, "/usr/bin/chromium"].find((path) => path && existsSync(path));

/** Runs in the page: times between pictures, times that scripts take in each, and memory before and after. */
async function measured(seconds) {
  const gaps = [], work = [], draw = studio.board.draw.bind(studio.board);
  studio.board.ticker.draw = (at) => {
    const begin = performance.now();
    draw(at);
    work.push(performance.now() - begin);
  };
  const heap = () => performance.memory?.usedJSHeapSize ?? 0;
  const before = heap(), end = performance.now() + 1000 * seconds;
  for (let last = performance.now(), now = last; now < end; last = now) {
    now = await new Promise(requestAnimationFrame);
    gaps.push(now - last);
  }
  const quantile = (list, share) => list.sort((a, b) => a - b)[Math.floor(share * (list.length - 1))];
  return {pictures: gaps.length, gap: {p50: quantile(gaps, 0.5), p95: quantile(gaps, 0.95), max: quantile(gaps, 1)},
    work: {p50: quantile(work, 0.5), p95: quantile(work, 0.95), max: quantile(work, 1)}, heap: [before, heap()].map((bytes) => Math.round(bytes / 1e6))};
}

const {address, close} = await served();
const browser = await playwright.chromium.launch({executablePath, args: ["--no-sandbox", "--disable-gpu", "--enable-precise-memory-info"]});
try {
  const page = await (await browser.newContext({viewport: {width: 1400, height: 900}})).newPage();
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  await page.goto(`${address}?signals=100&scopes=6&per=3&seconds=150`);
  await page.waitForFunction(() => window.studio);
  await page.evaluate(async () => {
    for (const source of ["rig.sensor[30]", "rig.sensor[31]"]) await studio.board.addSource(studio.board.scopes[0], source);
    studio.board.follow(60);
    await studio.context.run.play(5);  // until the window is full
  });
  await page.waitForFunction(() => studio.context.run.news.time > 62, null, {timeout: 60_000});
  await page.evaluate(() => studio.context.run.play(1));
  await page.waitForTimeout(1500);
  const busy = async () => Object.fromEntries((await session.send("Performance.getMetrics")).metrics.map(({name, value}) => [name, value])).TaskDuration;
  const before = await busy(), result = await page.evaluate(measured, Number(values.seconds)), share = (await busy() - before) / Number(values.seconds);
  console.log(JSON.stringify({workload: "20 of 100 signals at 1 kHz in 6 scopes, 60 s", ...result, mainThread: share}));
} finally {
  await browser.close();
  close();
}
