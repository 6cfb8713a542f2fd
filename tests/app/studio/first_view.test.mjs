// The first view of a large diagram shows whole blocks with readable letters.

import assert from "node:assert/strict";
import {test} from "node:test";
import {missing, Studio} from "./studio.mjs";

const chain = (count) => `stepwire: 1
title: A chain
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  start: {block: Step, time: 0.1 s, after: 1}
${Array.from({length: count}, (_, i) => `  lag${i + 1}: {block: Lag, u: ${i === 0 ? "start" : `lag${i}`}, tau: 10 ms}`).join("\n")}
record: [lag${count}]
`;
const wide = `stepwire: 1
title: Many blocks side by side
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  start: {block: Step, time: 0.1 s, after: 1}
${Array.from({length: 58}, (_, i) => `  lag${i + 1}: {block: Lag, u: ${i < 29 ? "start" : `lag${i - 28}`}, tau: 10 ms}`).join("\n")}
  sum: {block: Sum, u: [${Array.from({length: 29}, (_, i) => `lag${i + 30}`).join(", ")}]}
record: [sum]
`;
/** Minimum height of readable letters [px]. */
const readable = 9;

/** Returns for the visible drawing the smallest letters of blocks, and the number of wholly visible blocks. */
const view = (page) => page.evaluate(() => {
  const canvas = document.querySelector(".canvas").getBoundingClientRect(), blocks = [...document.querySelectorAll(".shape")];
  const inside = blocks.filter((one) => {
    const {left, right, top, bottom} = one.querySelector(".halo").getBoundingClientRect();
    return left >= canvas.left - 6 && right <= canvas.right + 6 && top >= canvas.top - 6 && bottom <= canvas.bottom + 6;
  });
  const scale = document.querySelector(".picture").getScreenCTM().a, sizes = inside.flatMap((one) => [...one.querySelectorAll("text:not(.warning)")].map((text) => parseFloat(getComputedStyle(text).fontSize) * scale));
  return {blocks: blocks.length, inside: inside.length, names: inside.map((one) => one.dataset.shape), least: Math.min(...sizes)};
});

for (const [name, text] of [["in a chain", chain(59)], ["side by side", wide]])
  test(`60 blocks ${name} begin with letters that can be read, where signals begin`, {skip: missing}, async () => {
    const studio = await Studio.opened(text), {page} = studio;
    try {
      await page.getByRole("button", {name: "Dismiss"}).click();
      await page.waitForSelector("[data-shape='start']");
      const {blocks, inside, names, least} = await view(page);
      assert.ok(blocks >= 60, `${blocks} blocks`);
      assert.ok(least >= readable, `letters of ${least} px`);
      assert.ok(inside >= 3, `${inside} blocks in view`);
      assert.ok(names.includes("start"), names.join(" "));
      if (process.env.STUDIO_SHOTS) await page.screenshot({path: `${process.env.STUDIO_SHOTS}/first-${blocks}-${name.replaceAll(" ", "-")}.png`});
      assert.deepEqual(studio.errors, []);
    } finally {
      await studio.close();
    }
  });
