// Measures the scopes in Chromium, on the program's own page, with 100 signals at 1 kHz. 6 scopes draw the newest 60 s of 20 signals. Then
// it measures zooming in the recorded data, and sliders. Prints lines of JSON with the goals; bench/studio formats them as a table.
// node frame_times.mjs [--seconds 20] [--zoom-at 100] [--short]; --seconds: of frames; --zoom-at: recorded seconds (at 10 times real time)
// before the zoom

import {Studio} from "../studio.mjs";
import {given, print, printQuantiles, quantile} from "../times.mjs";
import {hundredSignals} from "./hundred_signals.mjs";

const {seconds, "zoom-at": zoomAt} = given({seconds: [20, 5], "zoom-at": [100, 70]});

/** Runs in the page before its scripts: records the times of calls, answers and frames. */
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

/** Returns the times between pictures [ms]. */
async function gaps(seconds) {
  const found = [], end = performance.now() + 1000 * seconds;
  for (let last = await new Promise(requestAnimationFrame); last < end;) {
    const now = await new Promise(requestAnimationFrame);
    found.push(now - last);
    last = now;
  }
  return found;
}

/** Returns the times from a wheel event to the picture with the new samples [ms]. */
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

/** Opens another page on the same run; returns the time until all of its scopes are there [ms]. */
async function opened(studio) {
  const page = await studio.context.then((context) => context.newPage()), begin = performance.now();
  await page.goto(studio.address);
  await allScopes(page);
  const time = performance.now() - begin;
  await page.close();
  return time;
}

const allScopes = (page) => page.waitForFunction(() => document.querySelectorAll(".scope .trace").length === 20);

async function play(page, rate, until) {
  await page.locator(".run-buttons select").selectOption(rate);
  if ((await page.locator(".play").getAttribute("aria-label")) === "Play") await page.locator(".play").click();
  await page.waitForFunction((time) => parseFloat(document.querySelector(".run-time").textContent) >= time, until, {timeout: 300_000, polling: 200});
}

/** Measures frames, the page's process and its memory in real time. */
async function drawn(page) {
  const session = await page.context().newCDPSession(page), workload = "20 of 100 signals at 1 kHz in 6 scopes, 60 s";
  await session.send("Performance.enable");
  const used = async () => (await session.send("Performance.getMetrics")).metrics.find(({name}) => name === "ProcessTime").value;
  const inUse = async () => {
    await session.send("HeapProfiler.collectGarbage");
    return (await session.send("Runtime.getHeapUsage")).usedSize;
  };
  const heap = await inUse(), cpu = await used(), frames = await page.evaluate(gaps, seconds);
  printQuantiles(workload, "frame", "ms", frames, 16.8);
  print(workload, "page's process", "share of a core", (await used() - cpu) / seconds, 0.5);
  print(workload, "memory, grown by", "MB", (await inUse() - heap) / 1e6, 5);
}

/** In the page: moves a slider; returns the times until the server has accepted each value [ms]. */
async function slid() {
  const slider = document.querySelector(".tuned-slider");
  for (let place = 300; place < 700; place += 10) {
    slider.value = String(place);
    slider.dispatchEvent(new Event("input", {bubbles: true}));
    await new Promise((resolve) => setTimeout(resolve, 40));
  }
  return noted.sent.filter(({text}) => text.includes('"run.set"')).map(({at, text}) => noted.answers.get(JSON.parse(text).id) - at);
}

const studio = await Studio.opened(hundredSignals(), {seen: observe}), {page} = studio;
try {
  await page.getByRole("button", {name: "Dismiss"}).click();
  await allScopes(page);
  const starts = [await opened(studio), await opened(studio), await opened(studio)];
  print("studio", "start to usable, p50", "ms", quantile(starts, 0.5), 1000);
  await page.getByLabel("Time span shown").selectOption("60");
  await play(page, "10", 62);
  await play(page, "1", 62);
  await page.waitForTimeout(1500);
  await drawn(page);
  print("slider", "sent to taken over, p50", "ms", quantile(await page.evaluate(slid), 0.5), 5);
  await play(page, "10", zoomAt);
  await page.locator(".play").click();
  await page.getByLabel("Time span shown").selectOption("60");
  const zooms = await page.evaluate(zoomed, 40), workload = `zoom in ${Math.round(zoomAt * 1e5).toLocaleString("en")} samples`;
  printQuantiles(workload, "wheel to drawn", "ms", zooms.map(({all}) => all), 50);
  printQuantiles(workload, "request to numbers in the page", "ms", zooms.map(({server}) => server));
} finally {
  await studio.close();
}
