// What the studio's scopes cost and how long they take, measured in Chromium on the program's own page: 100 signals at 1 kHz, 20 of
// them drawn in 6 scopes, of the newest 60 s; then zooming in what was recorded, and sliders. Prints lines of JSON with the goals; bench/studio makes a table of them.
// node frame_times.mjs [--seconds 20] [--zoom-at 100]: of frames, and how many seconds are recorded (at 10 times real time) before it zooms

import {spawn} from "node:child_process";
import {existsSync, mkdtempSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {parseArgs} from "node:util";
import {hundredSignals} from "./hundred_signals.mjs";

const {values} = parseArgs({options: {seconds: {type: "string", default: "20"}, "zoom-at": {type: "string", default: "100"}}});
const playwright = (await import("playwright-core")).default;
const executablePath = [process.env.STEPWIRE_CHROMIUM, "/usr/bin/chromium"].find((path) => path && existsSync(path));
const quantile = (list, share) => [...list].sort((a, b) => a - b)[Math.floor(share * (list.length - 1))];
const print = (workload, by, unit, value, goal) => console.log(JSON.stringify({workload, by, unit, value: Number(value.toPrecision(3)), goal}));

/** Starts the studio on a diagram; resolves to its address. */
function started(folder) {
  const file = join(folder, "hundred.yaml");
  writeFileSync(file, hundredSignals());
  const server = spawn(process.env.STEPWIRE_PROGRAM, ["studio", "--no-open", file], {stdio: ["ignore", "pipe", "inherit"], env: {...process.env, XDG_STATE_HOME: folder}});
  const address = new Promise((resolve) => {
    let text = "";
    server.stdout.on("data", (more) => {
      const found = /http:\/\/\S+/.exec(text += more);
      if (found) resolve(found[0]);
    });
  });
  return {server, address};
}

/** Runs in the page before its scripts: notes when calls leave, answers come, and frames come. */
function observe() {
  const noted = (window.noted = {sent: [], answers: new Map(), frames: []});
  const Original = WebSocket;
  window.WebSocket = class extends Original {
    constructor(...args) {
      super(...args);
      this.addEventListener("message", ({data}) => {
        const at = performance.now();
        if (typeof data !== "string") noted.frames.push({at, view: new DataView(data).getUint16(6, true), bytes: data.byteLength});
        else if (data.startsWith('{"id"')) noted.answers.set(JSON.parse(data).id, at);
      });
    }
    send(text) {
      if (typeof text === "string" && !text.startsWith('{"ack"')) noted.sent.push({at: performance.now(), text});
      super.send(text);
    }
  };
}

/** Times between pictures [ms]. */
async function gaps(seconds) {
  const found = [], end = performance.now() + 1000 * seconds;
  for (let last = await new Promise(requestAnimationFrame); last < end;) {
    const now = await new Promise(requestAnimationFrame);
    found.push(now - last);
    last = now;
  }
  return found;
}

/** From a turn of the wheel to the picture with the samples of the new stretch [ms]. */
async function zoomed(times) {
  const over = document.querySelector(".scope .u-over"), box = over.getBoundingClientRect(), found = [];
  const wheel = (deltaY) => over.dispatchEvent(new WheelEvent("wheel", {deltaY, clientX: box.left + box.width / 2, clientY: box.top + 20, bubbles: true, cancelable: true}));
  for (let i = 0; i < times; ++i) {
    const begin = performance.now();
    wheel(i % 8 < 4 ? -500 : 500);
    for (;;) {
      const now = await new Promise(requestAnimationFrame), want = noted.sent.findLast(({at, text}) => at >= begin && text.includes("data.want"));
      const views = want && new Set(JSON.parse(want.text).views.map(({view}) => view));
      const first = want && noted.frames.find(({at, view}) => at > want.at && views.has(view));
      if (first) {
        found.push({all: Math.max(now, first.at) - begin, server: first.at - want.at});
        break;
      }
      if (now - begin > 5000) throw new Error("no samples came within 5 s");
    }
    await new Promise((resolve) => setTimeout(resolve, 150));
  }
  return found;
}

const folder = mkdtempSync(join(tmpdir(), "frame-times-")), {server, address} = started(folder);
const browser = await playwright.chromium.launch({executablePath, args: ["--no-sandbox", "--disable-gpu", "--enable-precise-memory-info"]});
try {
  const page = await (await browser.newContext({viewport: {width: 1400, height: 900}})).newPage(), session = await page.context().newCDPSession(page);
  await page.addInitScript(observe);
  await session.send("Performance.enable");
  const metric = async (name) => (await session.send("Performance.getMetrics")).metrics.find((one) => one.name === name)?.value ?? NaN;
  const play = async (rate, until) => {
    await page.locator(".run-buttons select").selectOption(rate);
    if ((await page.locator(".play").getAttribute("aria-label")) === "Play") await page.locator(".play").click();
    await page.waitForFunction((time) => parseFloat(document.querySelector(".run-time").textContent) >= time, until, {timeout: 300_000, polling: 200});
  };
  const begin = performance.now();
  await page.goto(await address);
  await page.waitForFunction(() => document.querySelectorAll(".scope .trace").length === 20, null, {timeout: 60_000});
  print("studio", "start to usable", "ms", performance.now() - begin, 1000);
  await page.getByRole("button", {name: "No, thank you"}).click({timeout: 5000}).catch(() => {});  // the tour, at a first visit
  await page.getByLabel("How much time is seen").selectOption("60");
  await play("10", 62);
  await play("1", 62);
  await page.waitForTimeout(1500);
  const inUse = async () => {
    await session.send("HeapProfiler.collectGarbage");
    return page.evaluate(() => performance.memory.usedJSHeapSize);
  };
  const heap = await inUse(), cpu = await metric("ProcessTime"), frames = await page.evaluate(gaps, Number(values.seconds));
  const workload = "20 of 100 signals at 1 kHz in 6 scopes, 60 s";
  print(workload, "frame, p50", "ms", quantile(frames, 0.5));
  print(workload, "frame, p95", "ms", quantile(frames, 0.95), 16.8);
  print(workload, "page's process", "share of a core", (await metric("ProcessTime") - cpu) / Number(values.seconds), 0.5);
  print(workload, "memory, grown by", "MB", (await inUse() - heap) / 1e6, 5);
  const set = await page.evaluate(async () => {
    const slider = document.querySelector(".tuned-slider");
    for (let place = 300; place < 700; place += 10) {
      slider.value = String(place);
      slider.dispatchEvent(new Event("input", {bubbles: true}));
      await new Promise((resolve) => setTimeout(resolve, 40));
    }
    return noted.sent.filter(({text}) => text.includes('"run.set"')).map(({at, text}) => noted.answers.get(JSON.parse(text).id) - at);
  });
  print("slider", "sent to taken over, p50", "ms", quantile(set, 0.5), 5);
  await play("10", Number(values["zoom-at"]));
  await page.locator(".play").click();
  await page.getByLabel("How much time is seen").selectOption("60");
  const zooms = await page.evaluate(zoomed, 40), samples = `zoom in ${Math.round(Number(values["zoom-at"]) * 1e5).toLocaleString("en")} samples`;
  print(samples, "wheel to drawn, p50", "ms", quantile(zooms.map(({all}) => all), 0.5));
  print(samples, "wheel to drawn, p95", "ms", quantile(zooms.map(({all}) => all), 0.95), 50);
  print(samples, "asked to come, p50", "ms", quantile(zooms.map((one) => one.server), 0.5));
  print(samples, "asked to come, p95", "ms", quantile(zooms.map((one) => one.server), 0.95), 5);
} finally {
  await browser.close();
  server.kill();
  await new Promise((ended) => server.once("exit", ended));
  rmSync(folder, {recursive: true});
}
