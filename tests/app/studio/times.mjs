// What scripts that measure share: order statistics, and lines of JSON of which bench/studio makes a table.

import {parseArgs} from "node:util";

export const quantile = (list, share) => [...list].sort((a, b) => a - b)[Math.floor(share * (list.length - 1))];

/** Options by name with what they are otherwise, and in a short round. */
export function given(options) {
  const {values} = parseArgs({options: {short: {type: "boolean"}, ...Object.fromEntries(Object.keys(options).map((name) => [name, {type: "string"}]))}});
  return Object.fromEntries(Object.entries(options).map(([name, [usual, short]]) => [name, Number(values[name] ?? (values.short ? short : usual))]));
}

/** A row of the table. `isExtreme`: other work on the machine may spoil it, so that a short round does not judge it. */
export const print = (workload, by, unit, value, goal, isExtreme = false) =>
  console.log(JSON.stringify({workload, by, unit, value: Number(value.toPrecision(3)), goal, isExtreme}));

/** The median with the goal, and the value that 95 % do not exceed. */
export function printQuantiles(workload, by, unit, list, goal) {
  print(workload, `${by}, p50`, unit, quantile(list, 0.5), goal);
  print(workload, `${by}, p95`, unit, quantile(list, 0.95), goal, true);
}
