#include "bench/look_up.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <random>

#include "blocks/register.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire {

namespace {

constexpr int points = 100;

/// Returns the height of a wave of 10 mm over 200 mm.
double height(double x) {
  return 10e-3 * std::sin(x / 15e-3);
}

plan::Plan corridor(const Registry& registry, const std::string& kind) {
  std::string text =
      "stepwire: 1\nstep: 1\nstop: 1\nblocks:\n  map:\n    block: Region\n    position: [0, 0]\n";
  text += fmt::format("    shape: {{half_width: 2e-3, {}: [", kind);
  for (int i = 0; i < points; ++i) {
    const double x = 0.2 * i / (points - 1);
    text += fmt::format("{}[{}, {}]", i > 0 ? ", " : "", x, height(x));
  }
  return plan::make_plan(diagram::Loader(registry).load_text(text + "]}\n", "corridor.yaml"));
}

/// Returns places beside the wave, two coordinates each.
std::vector<double> places(std::size_t count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> along(0.0, 0.2), beside(-20e-3, 20e-3);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    numbers.push_back(along(random));
    numbers.push_back(height(numbers.back()) + beside(random));
  }
  return numbers;
}

/// Returns the time of one call of the block [ns].
double cost(const plan::Plan& plan, const std::vector<double>& numbers) {
  AnyBlock block(plan.diagram.blocks.front().block);
  const BlockType& type = block.type();
  double distance = 0.0, nearest[2], direction[2];
  type.outputs[0].bind(block.get(), &distance, 1);
  type.outputs[1].bind(block.get(), nearest, 2);
  type.outputs[2].bind(block.get(), direction, 2);
  void* const end = static_cast<std::byte*>(block.get()) + type.bytes;
  const std::clock_t start = std::clock();
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    type.inputs[0].bind(block.get(), numbers.data() + i, 2);
    type.run_outputs[Specialization::nothing](block.get(), end);
  }
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return 1e9 * seconds / (0.5 * static_cast<double>(numbers.size()));
}

}  // namespace

std::vector<Result> measure_look_up(int times) {
  const Registry registry = blocks();  // must outlive the plans, whose blocks refer to it
  const std::vector<double> numbers = places(100000);
  std::vector<Result> results;
  for (const char* kind : {"corridor", "spline"}) {
    const plan::Plan plan = corridor(registry, kind);
    const std::string what = fmt::format("nearest point of a {} of {} points", kind, points);
    for (int i = 0; i < times; ++i) results.push_back({what, "interpreted", "ns", cost(plan, numbers), 1});
  }
  return results;
}

}  // namespace stepwire
