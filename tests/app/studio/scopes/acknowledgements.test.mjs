// When the server hears that a frame was drawn, so that a view gets no more frames than it would show.

import assert from "node:assert/strict";
import {mock, test} from "node:test";
import {bundled} from "./bundled.mjs";

const {Acknowledgements} = await bundled("connection/acknowledgements.ts");
const made = () => { const sent = []; return {sent, all: new Acknowledgements((sequence) => sent.push(sequence))}; };
const add = (all, view, ...sequences) => { for (const sequence of sequences) all.add({view, sequence}); };

test("a view without a pause answers at once", () => {
  const {sent, all} = made();
  add(all, 1, 5, 6);
  assert.deepEqual(sent, [5, 6]);
});

test("a view with a pause answers all but the newest when it is over, so that one frame more comes", (context) => {
  mock.timers.enable({apis: ["setTimeout"]});
  context.after(() => mock.timers.reset());
  const {sent, all} = made();
  all.pace(1, 80);
  add(all, 1, 1, 2);
  add(all, 2, 3);
  assert.deepEqual(sent, [3], "other views do not wait");
  mock.timers.tick(79);
  assert.deepEqual(sent, [3]);
  mock.timers.tick(1);
  assert.deepEqual(sent, [3, 1]);
  add(all, 1, 4);
  mock.timers.tick(80);
  assert.deepEqual(sent, [3, 1, 2]);
  mock.timers.tick(800);
  assert.deepEqual(sent, [3, 1, 2], "the newest is held back");
});

test("another wish answers all at once; what came over a connection that was lost is not answered", (context) => {
  mock.timers.enable({apis: ["setTimeout"]});
  context.after(() => mock.timers.reset());
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
  mock.timers.tick(800);
  add(all, 1, 6, 7);
  mock.timers.tick(80);
  assert.deepEqual(sent, [1, 2, 3, 6]);
});
