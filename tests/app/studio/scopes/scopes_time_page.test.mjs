// Time windows and cursors of scopes in the browser.

import assert from "node:assert/strict";
import {test} from "node:test";
import {until} from "../browser.mjs";
import {at, options, over, run, state} from "./scopes_page.mjs";

test("wheel stops following while data go on, F follows again", options, () => at(2, async (page) => {
  await page.evaluate(() => studio.context.run.play(1));
  await page.waitForFunction(() => studio.context.run.news.state === "playing");
  assert.equal(await state(page), "following");
  await over(page).hover({position: {x: 100, y: 40}});
  await page.mouse.wheel(0, -300);
  await page.waitForFunction(() => !studio.board.shared.window.isFollowing);
  assert.match(await state(page), /^looking back/);
  const [seen, time] = await page.evaluate(() => [studio.board.shared.window.at(0), studio.context.run.news.time]);
  await page.waitForFunction((before) => studio.context.run.news.time > before + 0.3, time);
  assert.deepEqual(await page.evaluate(() => studio.board.shared.window.at(studio.context.run.time)), seen);
  await page.locator("body").press("f");
  assert.ok(await page.evaluate(() => studio.board.shared.window.isFollowing));
}));

test("space pauses the model and not the scopes' time; a full stop is one tick", options, () => at(1, async (page) => {
  const tick = () => page.evaluate(() => studio.context.run.news.tick);
  const before = await tick();
  await page.locator("body").press(".");
  await page.waitForFunction((old) => studio.context.run.news.tick === old + 1, before);
  assert.match(await state(page), /paused/);
  await page.locator("body").press(" ");
  await page.waitForFunction(() => studio.context.run.news.state === "playing");
  await page.locator("body").press(" ");
  await page.waitForFunction(() => studio.context.run.news.state === "paused");
}));

test("a drag chooses a stretch, a double click goes back", options, () => at(3, async (page) => {
  const box = await over(page).boundingBox();
  await page.mouse.move(box.x + box.width * 0.1, box.y + 40);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.2, box.y + 40, {steps: 4});
  await page.mouse.up();
  const {low, high} = await page.evaluate(() => studio.board.shared.window.at(0));
  assert.ok(Math.abs(low - 1) < 0.05 && Math.abs(high - 2) < 0.05, `${low} to ${high}`);
  await over(page).dblclick({position: {x: 50, y: 40}});
  assert.ok(await page.evaluate(() => studio.board.shared.window.isFollowing));
}));

test("a peak of one sample is drawn to its height, near and far", options, () => at(30, async (page) => {
  const peak = () => page.evaluate(() => {
    const scope = studio.board.scopes[0], samples = scope.feed.samples.get(0);
    return {fed: Math.max(...samples.high), range: scope.groups[0].range.now};
  });
  for (const width of [30, 10, 100]) {
    await page.evaluate((seconds) => studio.board.shared.window.look({low: 0, high: seconds}), width);
    await until(async () => {
      const {fed, range} = await peak();
      return fed > 0.065 && range.high > fed;
    }, `the peak is seen in ${width} s`);
  }
}, {rate: 0}));

test("arrows move the cursor, which is said with its values", options, () => at(3, async (page) => {
  await page.locator(".scope").first().focus();
  await page.keyboard.press("Home");
  for (let i = 0; i < 5; ++i) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Alt+ArrowRight");
  await page.keyboard.press("Shift+End");
  const {a, b} = await page.evaluate(() => ({a: studio.board.shared.cursors.a, b: studio.board.shared.cursors.b}));
  assert.ok(Math.abs(a - 0.501) < 1e-9, `A ${a}`);
  assert.ok(b > 2.9, `B ${b}`);
  await page.waitForFunction(() => [...document.querySelectorAll("[aria-live]")].some((region) => /^A 0.501 s, B .*1\/\(B − A\).*cart.position .* mm/.test(region.textContent)));
  await page.keyboard.press("Escape");
  assert.ok(await page.locator(".statistics").isHidden());
}));

test("what lies between the cursors becomes a line of claims by a click", options, () => at(3, async (page) => {
  await page.evaluate(() => {
    document.addEventListener("studio:insert", (event) => { window.inserted = event.detail; event.preventDefault(); });
    studio.board.shared.cursors.put("a", 1, 0.001);
    studio.board.shared.cursors.put("b", 2, 0.001);
  });
  const row = page.locator(".statistics tbody tr").first();
  await row.waitFor();
  await row.getByRole("button").nth(3).click();
  const {section, text} = await page.evaluate(() => window.inserted);
  assert.equal(section, "claims");
  assert.match(text, /^\{that: the maximum of cart.position from 1 s to 2 s is 6\d\.\d+ mm, where: time >= 1 s && time <= 2 s, max: cart.position, equals: 6\d\.\d+ mm, within: 1 %\}$/);
}));

test("numbers between the cursors follow the run until it has passed them", options, () => at(0.5, async (page) => {
  await page.evaluate(() => {
    studio.board.shared.cursors.put("a", 0.2, 0.001);
    studio.board.shared.cursors.put("b", 2, 0.001);
  });
  const atB = page.locator(".statistics tbody tr").first().locator("td").nth(1);
  await atB.getByText("–").waitFor();
  await run(page, 2.5);
  await atB.getByText(/mm$/).waitFor();
}));
