#include "bench/workload.hpp"

#include <fmt/format.h>

#include "blocks/register.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire {

namespace {

const Registry& registry() {
  static const Registry known = stepwire::blocks();
  return known;
}

}  // namespace

plan::Plan w1_plan() {
  diagram::Loader loader(registry());
  return plan::make_plan(loader.load(STEPWIRE_BENCH_DIR "/w1.yaml"));
}

std::string w2_text(int blocks, int steps) {
  std::string text = fmt::format(
      "stepwire: 1\ntitle: W2 with {} blocks\nstep: 1 ms\nstop: {} ms\nsolver: rk4\nblocks:\n"
      "  src: {{block: Sine, frequency: 1 Hz}}\n  w: {{block: Gain, gain: 0.1, u: src}}\n",
      blocks, steps);
  std::string recorded;
  for (int j = 0; j < blocks / 5; ++j) {
    const std::string u = j == 0 ? "src" : fmt::format("u{}", j);
    text += fmt::format("  e{0}: {{block: Sum, signs: \"+-\", u: [{1}, x{0}]}}\n", j, u);
    text += fmt::format("  g{0}: {{block: Gain, gain: {1}, u: e{0}}}\n", j, 1 + j % 7);
    text += fmt::format("  x{0}: {{block: Integrator, u: g{0}}}\n", j);
    text += fmt::format("  p{0}: {{block: Gain, gain: {1}, u: x{0}}}\n", j, 0.9 + 0.01 * (j % 5));
    text += fmt::format("  u{0}: {{block: Sum, u: [p{1}, w]}}\n", j + 1, j);
    if (j < 8) recorded += fmt::format("{}x{}", j ? ", " : "", j);
  }
  return text + "record: [" + recorded + "]\n";
}

plan::Plan w2_plan(int blocks, int steps) {
  diagram::Loader loader(registry());
  return plan::make_plan(loader.load_text(w2_text(blocks, steps), "w2.yaml"));
}

}  // namespace stepwire
