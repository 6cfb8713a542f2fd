// Order statistics and output for measuring scripts; bench/studio formats their lines of JSON as a table.

import {parseArgs} from "node:util";

export const quantile = (list, share) => [...list].sort((a, b) => a - b)[Math.floor(share * (list.length - 1))];

/** Returns options by name, with their defaults, also for a short round. */
export function given(options) {
  const {values} = parseArgs({options: {short: {type: "boolean"}, ...Object.fromEntries(Object.keys(options).map((name) => [name, {type: "string"}]))}});
  return Object.fromEntries(Object.entries(options).map(([name, [usual, short]]) => [name, Number(values[name] ?? (values.short ? short : usual))]));
}

/** Prints a row of the table. `isExtreme`: other work on the machine may disturb the value, so a short round does not check the goal. */
export const print = (workload, by, unit, value, goal, isExtreme = false) =>
  console.log(JSON.stringify({workload, by, unit, value: Number(value.toPrecision(3)), goal, isExtreme}));

/** Prints the median with the goal, and the 95 % quantile. */
export function printQuantiles(workload, by, unit, list, goal) {
  print(workload, `${by}, p50`, unit, quantile(list, 0.5), goal);
  print(workload, `${by}, p95`, unit, quantile(list, 0.95), goal, true);
}
