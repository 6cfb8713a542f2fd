// Acknowledgement of drawn frames: a view receives no more frames than it shows.

import assert from "node:assert/strict";
import {test} from "node:test";
import {bundled} from "./bundled.mjs";

const {Acknowledgements} = await bundled("connection/acknowledgements.ts");
const made = () => { const sent = []; return {sent, all: new Acknowledgements((sequence) => sent.push(sequence))}; };
const add = (all, view, ...sequences) => { for (const sequence of sequences) all.add({view, sequence}); };

// Replaces the timers by those of a clock of its own until the test ends. Returns a function that advances it by milliseconds.
// The mock timers of node:test changed after node 18.
const clock = (context) => {
  const {setTimeout, clearTimeout} = globalThis;
  const waiting = new Map();
  let now = 0, last = 0;
  globalThis.setTimeout = (action, delay) => { waiting.set(++last, {action, at: now + delay}); return last; };
  globalThis.clearTimeout = (timer) => waiting.delete(timer);
  context.after(() => Object.assign(globalThis, {setTimeout, clearTimeout}));
  return (time) => {
    now += time;
    for (const [timer, {action, at}] of waiting) if (at <= now && waiting.delete(timer)) action();
  };
};

test("a view without a pause answers at once", () => {
  const {sent, all} = made();
  add(all, 1, 5, 6);
  assert.deepEqual(sent, [5, 6]);
});

test("a view with a pause answers all but the newest when it is over, so that one frame more comes", (context) => {
  const pass = clock(context);
  const {sent, all} = made();
  all.pace(1, 80);
  add(all, 1, 1, 2);
  add(all, 2, 3);
  assert.deepEqual(sent, [3], "other views do not wait");
  pass(79);
  assert.deepEqual(sent, [3]);
  pass(1);
  assert.deepEqual(sent, [3, 1]);
  add(all, 1, 4);
  pass(80);
  assert.deepEqual(sent, [3, 1, 2]);
  pass(800);
  assert.deepEqual(sent, [3, 1, 2], "the newest is held back");
});

test("another wish answers all at once; what came over a connection that was lost is not answered", (context) => {
  const pass = clock(context);
  const {sent, all} = made();
  all.pace(1, 80);
  add(all, 1, 1, 2);
  all.pace(1, 0);
  assert.deepEqual(sent, [1, 2]);
  add(all, 1, 3);
  assert.deepEqual(sent, [1, 2, 3]);
  all.pace(1, 80);
  add(all, 1, 4, 5);
  all.forget();
  pass(800);
  add(all, 1, 6, 7);
  pass(80);
  assert.deepEqual(sent, [1, 2, 3, 6]);
});
