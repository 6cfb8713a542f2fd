// The gallery as its readers meet it: in a browser, on wide and narrow screens, in light and dark, with and without scripts.

import assert from "node:assert/strict";
import {existsSync, readFileSync} from "node:fs";
import {join, relative} from "node:path";
import {after, before, test} from "node:test";
import {fileURLToPath} from "node:url";
import {Gallery, missing, nameOf, ways} from "./browser.mjs";
import {contrasts, headings, idsTwice, links, pictures, tagsOfDocument, tagsOfText, widths} from "./inspect.mjs";

const options = {skip: missing, timeout: 300_000};
let gallery;
before(async () => { if (!missing) gallery = await Gallery.made(); });
after(async () => { if (gallery) await gallery.gone(); });

for (const way of ways)
  test(`nothing scrolls sideways, pictures are there in their proportions, and texts can be read: ${nameOf(way)}`, options, () =>
    gallery.with(way, async (page) => {
      for (const place of gallery.kinds()) {
        await page.goto(gallery.url(place));
        await page.evaluate(() => document.querySelectorAll("details").forEach((part) => { part.open = true; }));
        const {content, window} = await page.evaluate(widths);
        assert.ok(content <= window, `${place} is ${content} px wide in ${window} px`);
        for (const {src, natural, shown} of await page.evaluate(pictures)) {
          assert.ok(natural > 0, `${place}: ${src} is not shown`);
          assert.ok(Math.abs(shown / natural - 1) < 0.02, `${place}: ${src} is distorted: ${shown} for ${natural}`);
        }
        for (const {text, ratio} of await page.evaluate(contrasts)) assert.ok(ratio >= 4.5, `${place}: '${text}' has a contrast of ${ratio}`);
      }
    }));

test("every link leads to something inside of the folder", options, () => gallery.with({}, async (page) => {
  const ids = new Map();
  const targets = [];
  for (const place of gallery.pages()) {
    await page.goto(gallery.url(place));
    ids.set(place, new Set(await page.evaluate(() => [...document.querySelectorAll("[id]")].map((part) => part.id))));
    for (const link of await page.evaluate(links)) targets.push({place, link});
  }
  assert.ok(targets.length > 50);
  for (const {place, link} of targets) {
    const url = new URL(link);
    if (url.protocol === "data:") continue;
    assert.equal(url.protocol, "file:", `${place}: ${link}`);
    const target = relative(gallery.folder, fileURLToPath(url));
    assert.ok(!target.startsWith(".."), `${place}: ${link} leaves the folder`);
    assert.ok(existsSync(join(gallery.folder, target)), `${place}: ${target} is not there`);
    if (url.hash && target.endsWith(".html")) assert.ok(ids.get(target).has(url.hash.slice(1)), `${place}: ${target} has no ${url.hash}`);
  }
}));

test("pages are read by a parser as they are written, with headings in order and each id once", options, () =>
  gallery.with({script: false}, async (page) => {
    for (const place of gallery.pages()) {
      await page.goto(gallery.url(place));
      assert.deepEqual(await page.evaluate(tagsOfDocument), tagsOfText(readFileSync(join(gallery.folder, place), "utf8")), place);
      assert.deepEqual(await page.evaluate(idsTwice), [], place);
      const levels = await page.evaluate(headings);
      assert.equal(levels.filter((level) => level === 1).length, 1, place);
      levels.reduce((above, level) => (assert.ok(level <= above + 1, `${place}: h${level} under h${above}`), level), 0);
      assert.equal(await page.locator("main").count(), 1, place);
      assert.equal(await page.locator("html[lang=en]").count(), 1, place);
    }
  }));

test("each picture of a page has words of its own", options, () => gallery.with({}, async (page) => {
  for (const entry of gallery.entries()) {
    await page.goto(gallery.url(`${entry}/index.html`));
    const words = await page.locator("main img").evaluateAll((images) => images.map((image) => image.alt));
    assert.ok(words.length > 0 && words.every((word) => word.length > 12), `${entry}: ${words}`);
    assert.equal(new Set(words).size, words.length, entry);
  }
}));

test("the front page counts the claims that the runs have judged, invariants apart", options, () => gallery.with({}, async (page) => {
  const judged = gallery.entries().flatMap((entry) => JSON.parse(readFileSync(join(gallery.folder, entry, "claims.json"), "utf8")));
  const claims = judged.filter((claim) => !claim.invariant), held = judged.filter((claim) => claim.invariant && claim.holds);
  await page.goto(gallery.url("index.html"));
  const line = await page.locator(".summary").textContent();
  assert.ok(line.startsWith(`${claims.filter((claim) => claim.holds).length} claims hold`), line);
  if (held.length > 0) assert.ok(line.includes(`${held.length} invariant`), line);
  assert.ok(gallery.said.trimEnd().endsWith(line), "the terminal ends with another verdict");
}));

test("a search leaves the figures that have all its words, and is still there on the way back", options, () => gallery.with({}, async (page) => {
  await page.goto(gallery.url("index.html"));
  const shown = () => page.locator(".card:visible .label").allTextContents();
  const all = await shown();
  assert.equal(all.length, gallery.entries().length);
  await page.keyboard.press("/");
  await page.keyboard.type("table compressed");
  assert.deepEqual(await shown(), ["Table 1"]);
  await page.locator("input[type=search]").fill("no figure has such words");
  assert.deepEqual(await shown(), []);
  await page.locator("input[type=search]").fill("FIG17-fx");
  assert.deepEqual(await shown(), ["Figure 17"]);
  await page.locator(".card:visible a").click();
  await page.goBack();
  assert.deepEqual(await shown(), ["Figure 17"]);
  await page.locator("input[type=search]").fill("");
  await page.getByRole("button", {name: "tables"}).click();
  assert.deepEqual(await shown(), ["Table 1"]);
  await page.getByRole("button", {name: "tables"}).click();
  assert.deepEqual(await shown(), all);
}));

test("arrow keys go through the figures in the order of the front page", options, () => gallery.with({}, async (page) => {
  await page.goto(gallery.url("index.html"));
  const order = await page.locator(".card a").evaluateAll((all) => all.map((link) => link.href));
  await page.goto(order[0]);
  for (const next of order.slice(1)) {
    await page.keyboard.press("ArrowRight");
    await page.waitForURL(next);
  }
  await page.keyboard.press("ArrowLeft");
  await page.waitForURL(order.at(-2));
  await page.locator("nav a[rel=up]").first().click();
  await page.waitForURL(/index\.html#figures$/);
}));

for (const way of ways.filter(({colorScheme}) => colorScheme === "light"))
  test(`a click enlarges a picture in its place, and there is a way back: ${nameOf(way)}`, options, () => gallery.with(way, async (page) => {
    const [entry] = gallery.entries();
    await page.goto(gallery.url(`${entry}/index.html`));
    const image = page.locator(".picture img").first(), frame = page.locator(".frame").first();
    const before = await image.boundingBox(), at = await frame.boundingBox();
    await page.mouse.click(at.x + 0.5 * at.width, at.y + 0.5 * at.height);
    await page.waitForURL(/#large-1$/);
    const large = await image.boundingBox();
    assert.ok(large.width >= 1.9 * before.width, `${large.width} px after ${before.width} px`);
    const room = await frame.evaluate((part) => ({inside: part.scrollWidth, outside: part.clientWidth}));
    assert.ok(room.inside > room.outside, "there is nothing to pan");
    const {content, window} = await page.evaluate(widths);
    assert.ok(content <= window, "the page itself scrolls sideways");
    if (way.script) await page.keyboard.press("Escape");
    else await page.locator(".reduce:visible").click();
    await page.waitForURL(/#picture-1$/);
    assert.ok(Math.abs((await image.boundingBox()).width - before.width) < 1);
  }));

test("an enlarged picture is moved by the mouse, and a click on it leads back", options, () => gallery.with({}, async (page) => {
  await page.goto(gallery.url(`${gallery.entries()[0]}/index.html`) + "#large-1");
  const frame = page.locator(".frame").first(), box = await frame.boundingBox();
  const left = await frame.evaluate((part) => part.scrollLeft);
  await page.mouse.move(box.x + 500, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 380, box.y + 200, {steps: 4});
  await page.mouse.up();
  assert.ok(Math.abs((await frame.evaluate((part) => part.scrollLeft)) - left - 120) < 2);
  await page.mouse.click(box.x + 500, box.y + 200);
  await page.waitForURL(/#picture-1$/);
}));

test("invariants that held are folded into one line, and claims are not", options, () => gallery.with({script: false}, async (page) => {
  let folded = 0;
  for (const entry of gallery.entries()) {
    const judged = JSON.parse(readFileSync(join(gallery.folder, entry, "claims.json"), "utf8"));
    const held = judged.filter((claim) => claim.invariant && claim.holds);
    await page.goto(gallery.url(`${entry}/index.html`));
    assert.equal(await page.locator(".claims li:visible").count(), judged.length - held.length, entry);
    if (held.length === 0) continue;
    folded += 1;
    assert.equal(await page.locator("#invariants summary").textContent(), `Held throughout: ${held.length}`);
    await page.locator("#invariants summary").click();
    assert.equal(await page.locator("#invariants li:visible").count(), held.length);
  }
  assert.ok(folded > 0);
}));

test("a browser makes PNG of twice the size, also of pages that were opened as files", options, () => gallery.with({colorScheme: "dark"}, async (page) => {
  await page.goto(gallery.url(`${gallery.entries()[0]}/index.html`));
  const natural = await page.locator(".picture img").first().evaluate((image) => [image.naturalWidth, image.naturalHeight]);
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator(".tools button").first().click()]);
  const png = readFileSync(await download.path());
  assert.equal(png.subarray(1, 4).toString(), "PNG");
  assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], natural.map((size) => 2 * size));
}));

test("copies of diagram files run where they lie", options, async () => {
  const {spawnSync} = await import("node:child_process");
  const file = gallery.pages().find((page) => /diagrams\/thesis\/fig15.*\.html$/.test(page)).replace(/\.html$/, "");
  const {status, stderr} = spawnSync(process.env.STEPWIRE_PROGRAM, ["check", join(gallery.folder, file)]);
  assert.equal(status, 0, String(stderr));
});
