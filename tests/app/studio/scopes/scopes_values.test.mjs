// Numbers, units, ranges and times in scopes and run bar, without a browser.

import assert from "node:assert/strict";
import {test} from "node:test";
import {celsius, m, near} from "./modules.mjs";

test("a number is written with the digits that count and a minus sign", () => {
  assert.equal(m.numberText(49.7712345), "49.771");
  assert.equal(m.numberText(-0.5), "−0.5");
  assert.equal(m.numberText(1.5e-7), "1.5e−7");
  assert.equal(m.numberText(2e9), "2e9");
  assert.equal(m.numberText(100000), "100000");
  assert.equal(m.numberText(NaN), "–");
});

test("labels of an axis have as many decimals as its step, and no minus before a zero", () => {
  assert.equal(m.decimalsOf(0.5), 1);
  assert.equal(m.decimalsOf(2.5), 1);
  assert.equal(m.decimalsOf(0.25), 2);
  assert.equal(m.decimalsOf(20), 0);
  assert.equal(m.decimalsOf(2e-6), 6);
  assert.equal(m.fixedText(-0.0001, 1), "0.0");
  assert.equal(m.fixedText(-12.34, 1), "−12.3");
});

test("a prefix puts the largest magnitude between 1 and 1000", () => {
  assert.deepEqual(m.prefixed("m", 0.04), {text: "mm", scale: 1000, offset: 0});
  assert.deepEqual(m.prefixed("N", 2500), {text: "kN", scale: 1e-3, offset: 0});
  assert.equal(m.prefixed("m/s", 0.002).text, "mm/s");
  assert.equal(m.prefixed("s", 5000).text, "s");
  assert.equal(m.prefixed("kg", 0.001).text, "kg");
  assert.equal(m.prefixed("m^2", 1e-6).text, "m^2");
  assert.equal(m.prefixed("1", 1e-6).text, "1");
  assert.equal(m.prefixed("m", 1).text, "m");
});

test("a value is shown with scale and offset, a slope per second", () => {
  near(m.shownOf(293.15, celsius), 20);
  assert.equal(m.perSecond("N s/m"), "(N s/m)/s");
});

test("a range of values grows at once and shrinks after two seconds", () => {
  const range = new m.YRange();
  range.update({low: 0, high: 1}, 0);
  assert.ok(range.update({low: 0, high: 10}, 0.1).high > 10);
  assert.ok(range.update({low: 0, high: 1}, 0.2).high > 10);
  assert.ok(range.update({low: 0, high: 1}, 2.0).high > 10);
  const shrunk = range.update({low: 0, high: 1}, 2.3);
  assert.ok(shrunk.high < 2 && shrunk.high > 1 && shrunk.low < 0);
});

test("a range chosen by hand stays until it shall fit again", () => {
  const range = new m.YRange();
  range.update({low: 0, high: 1}, 0);
  range.choose({low: -5, high: 5});
  assert.deepEqual(range.update({low: 0, high: 100}, 1), {low: -5, high: 5});
  range.fit();
  assert.ok(range.update({low: 0, high: 100}, 1.1).high > 100);
});

test("a constant has room above and below", () => {
  assert.deepEqual(m.padded({low: 5, high: 5}), {low: 4.5, high: 5.5});
  assert.deepEqual(m.padded({low: 0, high: 0}), {low: -1, high: 1});
  const rounding = m.padded({low: 10 - 1e-12, high: 10 + 1e-12});
  near(rounding.high - rounding.low, 1e-3, 1e-6);
});

test("time follows the newest, and stands still once it is zoomed", () => {
  const window = new m.TimeWindow(10);
  assert.deepEqual(window.at(3), {low: 0, high: 10});
  assert.deepEqual(window.at(25), {low: 15, high: 25});
  window.zoom(0.5, 20, 25);
  assert.equal(window.isFollowing, false);
  assert.deepEqual(window.at(40), {low: 17.5, high: 22.5});
  window.pan(1, 40);
  assert.deepEqual(window.at(40), {low: 22.5, high: 27.5});
  window.follow();
  assert.deepEqual(window.at(40), {low: 30, high: 40});
});

test("the clock of a run goes on between two news of it and never goes back", () => {
  const clock = new m.RunClock();
  clock.observe(0, 1, 0);
  clock.restart(0, 0);
  let last = 0;
  for (let at = 0; at < 2; at += 1 / 60) {
    if (Math.round(at * 60) % 6 === 0) clock.observe(at - 0.004 * (Math.round(at * 60) % 4), 1, at);
    const now = clock.read(at);
    assert.ok(now >= last, `${now} after ${last}`);
    last = now;
    near(now, at, 0.02);
  }
  clock.observe(2, 0, 2);
  assert.equal(clock.read(3), 2);
});

test("the clock of a run does not run away without news", () => {
  const clock = new m.RunClock();
  clock.observe(1, 1, 0);
  for (let at = 0; at < 10; at += 0.1) clock.read(at);
  assert.ok(clock.read(10) < 1.8);
});

test("latency runs from an input to the first picture that has its tick", () => {
  const latency = new m.Latency();
  const acts = latency.sent(100);
  latency.drawn(5, 105);
  acts(5.1);
  latency.drawn(5.05, 110);
  assert.equal(latency.median, undefined);
  latency.drawn(5.2, 118);
  assert.equal(latency.median, 18);
});

test("the pace goes in steps up to as fast as it goes", () => {
  assert.equal(m.nextRate(1, 1), 2);
  assert.equal(m.nextRate(10, 1), 0);
  assert.equal(m.nextRate(0, 1), 0);
  assert.equal(m.nextRate(0.1, -1), 0.1);
  assert.equal(m.rateText(0), "fastest");
});
