/** Returns a diagram of 100 signals at 1 kHz with a stop time of one hour; six figures draw 20 of them. */
export function hundredSignals() {
  const names = Array.from({length: 100}, (_, i) => `s${i + 1}`);
  const blocks = names.map((name, i) => `  ${name}: {block: Sine, amplitude: ${1 + (i % 7)} mm, frequency: ${(0.11 + 0.07 * i).toFixed(2)} Hz}`);
  const drawn = [4, 4, 3, 3, 3, 3], from = drawn.map((_, i) => drawn.slice(0, i).reduce((sum, count) => sum + count, 0));
  const figures = drawn.map((count, i) => `  - {plot: lines, x: time in s, y: [${names.slice(from[i], from[i] + count).map((name) => `${name} in mm`).join(", ")}]}`);
  return ["stepwire: 1", "title: A hundred signals", "step: 1 ms", "stop: 3600 s", "solver: rk4", "blocks:", ...blocks, `record: [${names.join(", ")}]`, "figure:", ...figures, ""].join("\n");
}
