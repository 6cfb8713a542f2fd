// Creates pictures of each view of the studio for inspection, at 1400, 1024 and 400 pixels, light and dark, and one sheet per view with all
// six.
// STEPWIRE_PROGRAM=build/stepwire node tests/app/studio/screenshots.mjs FOLDER [VIEW ...]

import {mkdirSync, readFileSync, writeFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import {newContext} from "./browser.mjs";
import {Studio} from "./studio.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../.."), [folder, ...only] = process.argv.slice(2);
const sizes = [[1400, 900], [1024, 700], [400, 800]], schemes = ["light", "dark"];
const press = (page, key) => page.keyboard.press(key);
const tab = async (page, name) => {
  const own = page.getByRole("tab", {name, exact: true});
  if (await own.isVisible()) await own.click();
};
const play = async (page, seconds, pace = "1") => {
  const select = page.locator(".run-buttons select");
  if (await select.isVisible()) await select.selectOption(pace);
  await page.locator(".play").click();
  await page.waitForFunction((time) => parseFloat(document.querySelector(".run-time").textContent) >= time, seconds, {timeout: 60000});
  await page.locator(".play").click();
  await page.waitForTimeout(300);
};

const cart = "diagrams/examples/70-force-feedback.yaml", scene = "diagrams/examples/72-figure-of-eight.yaml";
/** Views by name: a diagram, and the actions before the picture. */
const views = {
  "text-and-drawing": [cart, async (page) => { await page.locator("[data-shape]").nth(3).click(); }],
  drawing: [cart, async (page) => { await tab(page, "Drawing"); await page.locator(".canvas").focus(); for (const key of ["Right", "Right", "e"]) await press(page, key === "e" ? "e" : "ArrowRight"); await page.waitForTimeout(500); }],
  fault: [cart, async (page) => {
    await tab(page, "Text");
    await page.locator(".cm-content").focus();
    await press(page, "Control+End");
    await page.keyboard.type("  lost: {block: Gain, u: nothing}\n");
    await page.waitForTimeout(1500);
    await tab(page, "Drawing");
  }],
  scopes: [cart, async (page) => {
    await tab(page, "Scopes");
    await play(page, 0.5);
    const over = page.locator(".scope .u-over").first(), {width} = await over.boundingBox();
    await over.click({position: {x: 0.3 * width, y: 30}});
    await over.click({position: {x: 0.7 * width, y: 30}, modifiers: ["Shift"]});
    await page.waitForTimeout(600);
  }],
  tuning: [cart, async (page) => { await tab(page, "Tuning"); await page.waitForTimeout(500); }],
  figures: [cart, async (page) => { await tab(page, "Figures"); await play(page, 0.6); await page.waitForTimeout(1200); }],
  scene: [scene, async (page) => { await tab(page, "Scene"); await page.waitForSelector(".scene-canvas"); await page.locator(".scene-canvas").focus(); await page.keyboard.down("ArrowRight"); await page.waitForTimeout(1500); await page.keyboard.up("ArrowRight"); await page.waitForTimeout(300); }],
  mechanism: ["diagrams/thesis/fig26-polar-platform.yaml", async (page) => { await tab(page, "3-D"); await page.waitForTimeout(2500); }],
  gallery: [cart, async (page) => { await page.locator(".bar-end button[aria-haspopup=menu]").click(); await page.getByRole("menuitem", {name: /Examples/}).click(); await page.waitForTimeout(800); }],
  menu: [cart, async (page) => { await page.locator(".bar-end button[aria-haspopup=menu]").click(); await page.waitForTimeout(200); }],
  keys: [cart, async (page) => { await page.locator(".tabs [aria-selected=true]").focus(); await page.keyboard.type("?"); await page.waitForTimeout(300); }],
  palette: [cart, async (page) => { await tab(page, "Drawing"); await page.locator(".canvas").focus(); await press(page, "i"); await page.waitForTimeout(800); await page.keyboard.type("filter"); await page.waitForTimeout(400); }],
  tour: [cart, async (page) => { await page.locator(".bar-end button[aria-haspopup=menu]").click(); await page.getByRole("menuitem", {name: "Tour"}).click(); await page.waitForTimeout(500); await page.getByRole("button", {name: /Show me|Start|Begin|Yes/}).first().click({timeout: 2000}).catch(() => {}); await page.waitForTimeout(600); }],
  about: [cart, async (page) => { await page.locator(".bar-end button[aria-haspopup=menu]").click(); await page.getByRole("menuitem", {name: /About/}).click(); await page.waitForTimeout(600); }],
  loop: ["diagrams/examples/53-real-time-loop.yaml", async (page) => { await tab(page, "Loop"); await page.locator(".play").click(); await page.waitForTimeout(3000); }, ["--loop"]],
  conflict: [undefined, async (page, studio) => {
    await tab(page, "Text");
    await page.locator(".cm-content").focus();
    await press(page, "Control+Home");
    await press(page, "End");
    await page.keyboard.type("  # mine");
    writeFileSync(studio.path, studio.file.replace("value: 2", "value: 3"));
    await page.waitForTimeout(1500);
    await press(page, "Control+s");
    await page.waitForTimeout(1000);
  }],
};
const small = "stepwire: 1\ntitle: small\nstep: 1 ms\nstop: 1 s\nsolver: rk4\nrecord: [lag]\nblocks:\n  source: {block: Constant, value: 2}\n  lag: {block: Lag, u: source, tau: 0.4 s}\n";

/** Takes the pictures of a view in one colour scheme, at each size. The action runs once, at the widest size. */
async function pictures(name, colorScheme) {
  const [file, action, more = []] = views[name], [[width, height]] = sizes, options = {width, height, colorScheme, more}, say = (text) => console.log(`${name} ${colorScheme}: ${text}`);
  const studio = await (file ? Studio.on(join(root, file), options) : Studio.opened(small, options)), {page} = studio, paths = [];
  try {
    page.setDefaultTimeout(8000);
    await page.getByRole("button", {name: "Dismiss"}).click().catch(() => {});
    await page.waitForSelector("[data-shape]", {state: "attached"}).catch(() => {});
    await page.waitForTimeout(700);
    await action(page, studio).catch((thrown) => say(thrown.message.split("\n")[0]));
    for (const [w, h] of sizes) {
      await page.setViewportSize({width: w, height: h});
      await page.waitForTimeout(400);
      paths.push(join(folder, `${name}-${w}-${colorScheme}.png`));
      await page.screenshot({path: paths[paths.length - 1]});
      const [content, own] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
      if (content > own) say(`at ${w} the page is ${content} wide`);
    }
    if (studio.errors.length > 0) say(studio.errors.join("; "));
  } finally {
    await studio.close();
  }
  return paths;
}

/** Returns a picture of all pictures of a view side by side. */
async function sheet(name, paths) {
  const context = await newContext({viewport: {width: 2000, height: 1400}}), page = await context.newPage();
  const images = paths.map((path) => `<img style="height:640px;margin:4px;border:1px solid #888" src="data:image/png;base64,${readFileSync(path).toString("base64")}">`).join("");
  await page.setContent(`<body style="margin:0;background:#777">${images}</body>`);
  await page.screenshot({path: join(folder, `sheet-${name}.png`), fullPage: true});
  await context.close();
}

mkdirSync(folder, {recursive: true});
for (const name of only.length > 0 ? only : Object.keys(views)) {
  const paths = [];
  for (const colorScheme of schemes) paths.push(...await pictures(name, colorScheme));
  await sheet(name, paths);
  console.log(name);
}
