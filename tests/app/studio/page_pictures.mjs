// Creates the pictures for the README of the studio, with the cart of the main README.
// STEPWIRE_PROGRAM=build/stepwire node tests/app/studio/page_pictures.mjs engine/app/studio/pictures

import {mkdirSync, readFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import {Studio} from "./studio.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../.."), [folder] = process.argv.slice(2);
const cart = /```yaml\n([^]*?)```/.exec(readFileSync(join(root, "README.md"), "utf8"))[1];
const field = (page, name) => page.getByRole("textbox", {name: new RegExp(`^${name}`)});

/** Plays up to a time. */
async function playTo(page, time) {
  await page.getByLabel(/^Speed/).selectOption({value: "1"});
  await page.getByRole("button", {name: "Play"}).click();
  await page.waitForFunction((least) => parseFloat(document.querySelector(".run-time").textContent) >= least, time);
}

async function setTo(page, name, value) {
  await field(page, name).fill(value);
  await field(page, name).press("Enter");
  await page.getByText(new RegExp(`^${value} from tick`)).waitFor();
}

/** Drops a wire from the cart's position on the sum of forces. */
async function refusedWire(page) {
  await page.locator("[data-shape='cart']").hover();
  const output = await page.locator("[data-shape='cart'] .port-output").first().boundingBox(), block = await page.locator("[data-shape='net'] > .halo").boundingBox();
  await page.mouse.move(output.x + 4, output.y + 4);
  await page.mouse.down();
  await page.mouse.move(output.x - 30, output.y + 30, {steps: 3});
  await page.waitForSelector(".canvas.connecting");
  await page.mouse.move(block.x + block.width / 2, block.y + block.height / 2, {steps: 3});
  await page.mouse.up();
  await page.waitForSelector(".refusal");
}

async function pinnedRun(page) {
  await playTo(page, 1);
  await setTo(page, "mass", "4 kg");
  await page.waitForFunction(() => document.querySelector(".run-time").title.includes("ended"));
  await page.getByRole("button", {name: "Pin run"}).click();
  await page.locator(".pin-label").waitFor();
  await setTo(page, "mass", "1 kg");
  await page.getByRole("button", {name: "Restart"}).click();
  await playTo(page, 2.9);
  await page.waitForFunction(() => document.querySelector(".run-time").title.includes("ended"));
  const over = page.locator(".scope .u-over").first(), {width} = await over.boundingBox();
  await over.click({position: {x: 0.3 * width, y: 30}});
  await over.click({position: {x: 0.7 * width, y: 30}, modifiers: ["Shift"]});
  await page.waitForTimeout(800);
}

const pictures = {
  wire: [".pane-drawing", refusedWire],
  runs: [".pane-scopes", pinnedRun],
  sliders: [".pane-tuning", async (page) => { await setTo(page, "mass", "3 kg"); }],
  palette: [undefined, async (page) => { await page.locator(".canvas").focus(); await page.keyboard.press("i"); await page.getByLabel("Search blocks").fill("lag"); await page.waitForTimeout(500); }],
};

mkdirSync(folder, {recursive: true});
for (const [name, [pane, action]] of Object.entries(pictures)) {
  const studio = await Studio.opened(cart, {name: "cart.yaml", width: 1280, height: 800}), {page} = studio;
  try {
    await page.getByRole("button", {name: "Dismiss"}).click();
    await page.waitForSelector("[data-shape='cart']");
    await action(page);
    const shown = pane ? page.locator(pane) : page.locator("dialog[open]");
    await page.screenshot({path: join(folder, `${name}.png`), clip: await shown.boundingBox()});
  } finally {
    await studio.close();
  }
}
