// Shared functions of the tests of scene, figures, mechanism and examples: the built page in Chromium, from STUDIO_PAGE=FOLDER or build/.

import assert from "node:assert/strict";
import {openPage} from "./scene_page.mjs";
import {built as folder, skip} from "./two_blocks.mjs";

export {skip};
export const loaded = {run: 1, step: 0.001, stop: 1, columns: [], parameters: [], scopes: [], inputs: [], scene: false, figures: 0, claims: []};
export const text = (page, selector) => page.locator(selector).first().textContent();

/** Opens the page with a pane in front, and closes it in any case. */
export async function withPage(answers, pane, view, run) {
  const opened = await openPage(folder, answers, view);
  try {
    if (pane) {
      await opened.page.locator(`#tab-${pane}`).click();
      await opened.page.waitForSelector(pane === "scene" ? ".scene-canvas" : `#pane-${pane} .view > *:not([hidden])`);
    }
    await run(opened);
    assert.deepEqual(opened.errors, [], "errors of the page");
  } finally {
    await opened.close();
  }
}

export const info = {
  title: "Ring", x: [-0.02, 0.02], y: [-0.01, 0.01], background: "#102030", pointer: {name: "pointer", held: "pointer_held", text: "Press and move: a spring pulls the ball to you."},
  objects: [{name: "walls", kind: "walls", text: "", walls: [{points: [[-0.019, -0.009], [0.019, -0.009], [0.019, 0.009], [-0.019, 0.009]], closed: true}]}, {name: "ball", kind: "point", text: "", walls: []}],
};
export const instant = (x, y, input = null) => ({news: "scene", time: 0.5, input, shapes: [
  {object: 0, wall: 0, points: [], size: 0, width: 0.0004, color: "#00ff00", crossed: false, shown: true}, {object: 1, points: [[x, y]], size: 0.002, width: 0, color: "#ff0000", crossed: false, shown: true}]});
export const withScene = {"run.load": () => ({...loaded, scene: true}), scene: () => ({scene: info})};

export const curve = (count) => ({x: Array.from({length: count}, (_, i) => i / count), y: Array.from({length: count}, (_, i) => Math.sin(i / 50))});
export const figureOf = (count) => ({width: 680, height: 440, panels: [{panel: "plot", box: [0, 0, 680, 440], x: {label: "time", unit: "s", range: [0, 1]}, y: {label: "position", unit: "mm", range: [-1, 1]},
  marks: [{mark: "line", curves: [curve(count)], line: {color: "#0072B2"}}]}]});

/** Selects an entry of the page's menu. */
export const more = async (page, name) => {
  await page.getByRole("button", {name: "More", exact: true}).click();
  await page.getByText(name).click();
};
