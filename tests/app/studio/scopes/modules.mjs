// Shared modules of the tests of scopes, run bar and tuning without a browser.

import assert from "node:assert/strict";
import {bundled} from "./bundled.mjs";

export const m = await bundled("scopes/numbers.ts", "scopes/display_unit.ts", "scopes/y_range.ts", "scopes/time_window.ts", "scopes/samples.ts", "scopes/cursors.ts",
  "scopes/statistics.ts", "scopes/claim_text.ts", "scopes/figure_text.ts", "scopes/yaml_text.ts", "scopes/palette.ts", "scopes/difference.ts", "scopes/trace.ts",
  "scopes/paint.ts", "scopes/axis_group.ts", "run/run_clock.ts", "run/latency.ts", "run/rates.ts", "connection/frame.ts");
export const tuning = await bundled("tuning/parameter_range.ts", "tuning/set_queue.ts", "tuning/tuning_list.ts");
export const pinned = await bundled("scopes/pin_history.ts");
export const lists = await bundled("scopes/signal_list.ts", "scopes/kept_layout.ts", "scopes/scope_svg.ts");
export const millimetres = {text: "mm", scale: 1000, offset: 0}, celsius = {text: "degC", scale: 1, offset: -273.15};
export const samples = (time, values) => { const own = Float64Array.from(values); return {time: Float64Array.from(time), low: own, high: own}; };
export const near = (a, b, within = 1e-9) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);
