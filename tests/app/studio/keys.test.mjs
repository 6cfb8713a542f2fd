// Keys of the list, with the focus on different elements.

import assert from "node:assert/strict";
import {test} from "node:test";
import {until} from "./browser.mjs";
import {cartText} from "./cart.mjs";
import {missing, Studio} from "./studio.mjs";

async function withStudio(action) {
  const studio = await Studio.opened(cartText("cart.position, spring"));
  try {
    await studio.page.getByRole("button", {name: "Dismiss"}).click();
    await studio.page.waitForSelector("[data-shape='cart']");
    await studio.page.waitForSelector(".scope canvas");
    await action(studio.page);
    assert.deepEqual(studio.errors, []);
  } finally {
    await studio.close();
  }
}

const paneOfFocus = (page) => page.evaluate(() => document.activeElement.closest(".pane")?.id ?? document.activeElement.tagName);
const isPlaying = (page) => page.locator(".play").getAttribute("aria-label").then((label) => label === "Pause");

test("F6 goes through all panes that are seen, and back", {skip: missing}, () => withStudio(async (page) => {
  await page.locator(".cm-content").focus();
  const order = ["pane-drawing", "pane-scopes", "pane-tuning", "pane-text"];
  for (const pane of [...order, ...order]) {
    await page.keyboard.press("F6");
    assert.equal(await paneOfFocus(page), pane);
  }
  for (const pane of ["pane-tuning", "pane-scopes", "pane-drawing", "pane-text"]) {
    await page.keyboard.press("Shift+F6");
    assert.equal(await paneOfFocus(page), pane);
  }
}));

test("each digit of the list shows its pane with the focus in it, and its keys work at once", {skip: missing}, () => withStudio(async (page) => {
  await page.locator(".canvas").focus();
  await page.keyboard.press("?");
  const listed = await page.locator("dialog dt").evaluateAll((all) => all.map((one) => one.textContent).filter((key) => /^[1-9]$/.test(key)));
  await page.keyboard.press("Escape");
  assert.deepEqual(listed, ["1", "2", "3", "4", "5", "6", "8"]);
  const panes = {2: "drawing", 3: "scopes", 4: "scene", 5: "mechanism", 6: "figures"};
  for (const [digit, pane] of Object.entries(panes)) {
    await page.keyboard.press(digit);
    await page.waitForFunction((id) => document.activeElement.closest(".pane")?.id === id, `pane-${pane}`);
  }
  await page.keyboard.press("2");
  await page.keyboard.press("ArrowRight");
  await page.waitForSelector(".shape.selected");
  await page.keyboard.press("i");
  await page.getByLabel("Search blocks").waitFor();
  await page.keyboard.press("Escape");
  await page.locator(".canvas").focus();
  await page.keyboard.press("8");
  assert.equal(await paneOfFocus(page), "pane-tuning");
  await page.locator(".canvas").focus();
  await page.keyboard.press("1");
  assert.equal(await paneOfFocus(page), "pane-text");
}));

test("Space plays and pauses from the drawing, a scope, a slider and behind a click on a button", {skip: missing}, () => withStudio(async (page) => {
  await page.getByLabel(/^Speed/).selectOption({value: "0.1"});  // the run must not end meanwhile
  const places = [() => page.locator(".canvas").focus(), () => page.locator(".scope").first().focus(), () => page.locator(".tuned-slider").first().focus(),
    () => page.getByRole("separator").first().focus(), () => page.getByRole("button", {name: "Zoom in (+)"}).click()];
  for (const [i, place] of places.entries()) {
    await place();
    await page.keyboard.press("Space");
    await until(async () => await isPlaying(page) === (i % 2 === 0), `place ${i}`);
  }
}));

test("a button that was reached by Tab is pressed by Space", {skip: missing}, () => withStudio(async (page) => {
  await page.locator(".canvas").focus();
  await page.keyboard.press("Shift+Tab");
  assert.equal(await page.evaluate(() => document.activeElement.tagName), "BUTTON");
  await page.keyboard.press("Space");
  assert.equal(await isPlaying(page), false);
}));
