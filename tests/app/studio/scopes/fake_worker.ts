// Thread of a FakeRun: steps it by the clock and sends frames, of which at most two per view are unacknowledged.

import {FakeRun} from "./fake_run";

let run: FakeRun, views: any[] = [], sequence = 0, last = performance.now();
const waiting = new Map<number, number>(), sent = new Map<number, string>();
const post = (message: any, transfer: Transferable[] = []) => (self as any).postMessage(message, transfer);

function send(view: any): void {
  const key = JSON.stringify([view, view.follow != null || view.to > run.news.time ? run.news.tick : 0, run.news.run]);
  if (sent.get(view.view) === key || (waiting.get(view.view) ?? 0) >= 2) return;
  sent.set(view.view, key);
  waiting.set(view.view, (waiting.get(view.view) ?? 0) + 1);
  const frame = run.frame(view, view.view, ++sequence);
  post({frame}, [frame.time.buffer, ...frame.columns.map(({buffer}) => buffer)] as Transferable[]);
}

function beat(): void {
  const now = performance.now(), before = run.news.state;
  run.advance((now - last) / 1000);
  last = now;
  for (const view of views) send(view);
  if (before === "playing") post({news: "run", ...run.news});
  if (before === "playing" && run.news.state === "ended") post({news: "claims", claims: [{that: "the cart stays within 60 mm", verdict: "FAIL", text: "69.9 mm"}, {that: "it comes to rest", verdict: "ok", text: "0.1 mm/s"}]});
}

self.onmessage = ({data}: MessageEvent) => {
  if (data.shape) {
    run = new FakeRun(data.shape);
    setInterval(beat, 16);
  } else if (data.views) views = data.views;
  else if (data.ack !== undefined) waiting.set(data.ack, Math.max(0, (waiting.get(data.ack) ?? 1) - 1));
  else {
    try {
      post({id: data.id, result: run.call(data.name, data.args)});
      post({news: "run", ...run.news});
    } catch (fault) {
      post({id: data.id, fault});
    }
  }
};
