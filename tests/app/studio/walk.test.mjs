// Walk through the page without a mouse: every control has a name and is large enough for a finger. Tab reaches it and its focus is
// visible.

import assert from "node:assert/strict";
import {test} from "node:test";
import {cartText} from "./cart.mjs";
import {missing, Studio} from "./studio.mjs";

const text = cartText("cart.position, spring");
/** Minimum height and width of controls outside of text lines [px]; WCAG 2.2, target size (minimum). */
const target = 24;

/** In the page: returns all visible controls, with their names and sizes. */
function controls() {
  const named = (one) => one.getAttribute("aria-label") || one.getAttribute("title") || [...(one.labels ?? [])].map((label) => label.textContent).join(" ") || (one.matches("select, input, textarea") ? one.getAttribute("placeholder") : one.textContent) || "";
  const all = [...document.querySelectorAll("button, select, input, summary, a[href], [role=button], [role=tab], [role=option][tabindex], [role=separator], [role=slider]")];
  return all.filter((one) => one.checkVisibility({checkOpacity: true, checkVisibilityCSS: true}) && !one.closest(".cm-editor")).map((one) => {
    const {width, height} = one.getBoundingClientRect();
    return {what: one.outerHTML.slice(0, 120), name: named(one).trim(), width, height, tag: one.tagName, type: one.type, role: one.getAttribute("role")};
  });
}

/** Returns the faults of the controls that are visible now. */
async function faults(page) {
  const found = await page.evaluate(controls), small = ({width, height, type, role}) => Math.min(width, height) < target - 0.5 && type !== "range" && role !== "separator";
  return [...(found.length > 5 ? [] : [`there are ${found.length} controls`]), ...found.filter(({name}) => !name).map(({what}) => `${what} has no name`),
    ...found.filter(small).map(({what, width, height}) => `${what} is ${width} x ${height}`)];
}

async function atSize(width, height, action) {
  const studio = await Studio.opened(text, {width, height});
  try {
    await studio.page.getByRole("button", {name: "Dismiss"}).click();
    if (width > 720) await studio.page.waitForSelector("[data-shape='cart']");  // on a narrow page it is behind a tab
    await action(studio.page);
    assert.deepEqual(studio.errors, []);
  } finally {
    await studio.close();
  }
}

for (const [width, height] of [[1400, 900], [400, 800]])
  test(`each control has a name and is large enough at ${width} px, in every pane`, {skip: missing}, () => atSize(width, height, async (page) => {
    for (const tab of await page.getByRole("tab").all()) {
      if (!await tab.isVisible()) continue;
      await tab.click();
      await page.waitForSelector(`#${await tab.getAttribute("aria-controls")} .view > *:not([hidden])`);
      let wrong = await faults(page);
      for (let i = 0; i < 20 && wrong.length > 0; ++i) {  // a view may still be loading
        await page.waitForTimeout(100);
        wrong = await faults(page);
      }
      assert.deepEqual(wrong, [], await tab.textContent());
    }
  }));

test("Tab reaches every control of the page and goes round, and each shows that it has the focus", {skip: missing}, () => atSize(1400, 900, async (page) => {
  const seen = new Set();
  await page.locator(".bar select").first().focus();
  for (let i = 0; i < 120; ++i) {
    const now = await page.evaluate(() => {
      const one = document.activeElement, style = getComputedStyle(one), pane = one.closest(".bar, .pane, .tabs");
      const isShown = style.outlineStyle !== "none" && parseFloat(style.outlineWidth) > 0 || style.boxShadow !== "none" || one.matches(".cm-content, [data-focus], .pane");
      return {key: `${one.tagName} ${one.getAttribute("aria-label") ?? one.title ?? ""} ${one.textContent.slice(0, 20)}`, where: pane?.className ?? "", isShown};
    });
    assert.ok(now.isShown || now.key.startsWith("BODY"), `${now.key} in ${now.where} does not show its focus`);
    seen.add(now.where);
    if (now.where.includes("pane-text")) await page.keyboard.press("Escape");  // Tab indents in the text until Esc is pressed
    await page.keyboard.press("Tab");
  }
  const all = [...seen].join(" ");
  for (const place of ["bar", "pane-text", "pane-drawing", "tabs", "pane-scopes", "pane-tuning"]) assert.ok(all.includes(place), `${place} is not reached: ${all}`);
}));

test("a block is inserted, connected, changed and deleted without a mouse", {skip: missing}, () => atSize(1400, 900, async (page) => {
  const content = () => page.locator(".cm-content").evaluate((one) => [...one.querySelectorAll(".cm-line")].map((line) => line.textContent).join("\n"));
  await page.locator(".canvas").focus();
  await page.keyboard.press("i");
  await page.getByLabel("Search blocks").fill("Gain");
  await page.getByLabel("source of u").selectOption("cart.velocity");
  await page.getByLabel("Search blocks").press("Enter");
  await page.waitForSelector("[data-shape='gain']");
  assert.match(await content(), /gain: \{block: Gain, .*u: cart\.velocity\}/);
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+z");
  await page.waitForSelector("[data-shape='gain']", {state: "detached"});
  assert.doesNotMatch(await content(), /velocity/);
  assert.equal((await content()).trim(), text.trim(), "one undo takes back the block with its wire");
  await page.locator(".canvas").focus();
  for (let i = 0; i < 6 && !await page.locator("[data-shape='cart'].selected").count(); ++i) await page.keyboard.press(i % 2 ? "ArrowLeft" : "ArrowRight");
  await page.keyboard.press("e");
  await page.locator(".card input[id='card-initial_position']").fill("0.2 m");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector(".cm-content").textContent.includes("initial_position: 0.2 m"));
}));
