// Behaviour of a page that has lost its server and connects again.

import assert from "node:assert/strict";
import {test} from "node:test";
import {until} from "./browser.mjs";
import {skip, withPage} from "./two_blocks.mjs";

const lines = (page) => page.locator(".cm-content").evaluate((content) => [...content.querySelectorAll(".cm-line")].map((line) => line.textContent).join("\n"));

test("a page that lost its server says so, keeps what is typed, and goes on once it is there again", {skip}, () => withPage(async ({page, diagram, calls, cut, news}) => {
  let isBack = false;
  cut(() => isBack);
  await page.getByText("no connection; reconnecting").waitFor();
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+Home");
  await page.keyboard.press("End");
  await page.keyboard.type("  # typed without a server");
  await page.waitForTimeout(1200);
  assert.doesNotMatch(diagram.text, /without a server/);
  const before = calls.length;
  isBack = true;
  await until(() => diagram.text.startsWith("stepwire: 1  # typed without a server\n"));
  assert.equal(await page.getByText("no connection; reconnecting").isVisible(), false);
  const again = calls.slice(before).map(({call}) => call);
  for (const call of ["hello", "data.want", "edit", "graph", "language"]) assert.ok(again.includes(call), `${call} is not among ${again}`);
  diagram.edit([{from: 0, to: 0, text: "# another page\n"}]);
  news({news: "edited", file: 0, version: diagram.version, changes: [{from: 0, to: 0, text: "# another page\n"}]});
  await page.waitForFunction(() => document.querySelector(".cm-line").textContent === "# another page");
  assert.equal(await lines(page), diagram.text);
}));

test("where the server has another text after it was lost, what was typed is not lost, and nothing is doubled", {skip}, () => withPage(async ({page, diagram, cut}) => {
  let isBack = false;
  cut(() => isBack);
  await page.getByText("no connection; reconnecting").waitFor();
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+End");
  await page.keyboard.type("# mine");
  diagram.edit([{from: 0, to: 0, text: "# of another page\n"}]);
  isBack = true;
  await until(() => diagram.text.startsWith("# of another page\n") && diagram.text.endsWith("# mine"));
  await page.waitForFunction((own) => document.querySelector(".cm-content").textContent.includes(own), "# of another page");
  assert.equal(await lines(page), diagram.text);
}));
