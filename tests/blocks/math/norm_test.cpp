#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "blocks/haptics/region/plane.hpp"
#include "blocks/haptics/region/space.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// The first value of a column of blocks that take constants. `signal`: what is recorded.
double value_of(const std::string& blocks, const std::string& name, const std::string& signal = "y") {
  return column(run_text(fmt::format("step: 10 ms\nstop: 10 ms\nsolver: euler\nblocks:\n{}record: [{}]\n",
                                     blocks, signal)),
                name)[0];
}

double norm_of(const std::string& vector, const std::string& kind = "euclidean") {
  return value_of(fmt::format("  u: {{block: Constant, value: {}}}\n  y: {{block: Norm, u: u, kind: {}}}\n",
                              vector, kind),
                  "y");
}

const double sizes[] = {1.0, 1e-200, 1e200, 1e-300, 1e300};

}  // namespace

TEST_CASE("Norm is right where the squares of its numbers are too large or too small for a double") {
  CHECK(norm_of("[3, 4]") == 5.0);
  CHECK(norm_of("[3e-200, 4e-200]") == Approx(5e-200).epsilon(1e-15));
  CHECK(norm_of("[1e200, 1e200]") == Approx(std::sqrt(2.0) * 1e200).epsilon(1e-15));
  CHECK(norm_of("[5e-324]") == 5e-324);
  CHECK(norm_of("[3e-310, 4e-310, 0]") == Approx(5e-310).margin(1e-323));
  CHECK(norm_of("[1e200, 1e-200, 1]") == 1e200);
  CHECK(norm_of("[1, 1e-200]") == 1.0);
  CHECK(norm_of("[3e-200, -4e-200]", "sum") == Approx(7e-200));
  CHECK(norm_of("[3e200, -4e200]", "max") == 4e200);
}

TEST_CASE("a turn does not depend on the length of its axis or its quaternion") {
  for (const double size : sizes) {
    INFO(size);
    // Half a turn about the line x = y takes x to y.
    const std::string vector = "  u: {block: Constant, value: [1, 0, 0]}\n";
    const std::string quaternion = fmt::format("  q: {{block: Constant, value: [0, {0}, {0}, 0]}}\n", size);
    CHECK(value_of(vector + quaternion + "  y: {block: Rotate3D, u: u, quaternion: q}\n", "y.2") ==
          Approx(1.0));
    const std::string axis = fmt::format("  axis: {{block: Constant, value: [{0}, {0}, 0]}}\n", size);
    const std::string angle = "  angle: {block: Constant, value: {value: 3.141592653589793, unit: rad}}\n";
    CHECK(value_of(vector + axis + angle + "  y: {block: Rotate3D, u: u, axis: axis, angle: angle}\n",
                   "y.2") == Approx(1.0));
    const std::string rate = "  w: {block: Constant, value: {value: [0, 0, 0], unit: rad/s}}\n";
    const std::string start = fmt::format(
        "  y: {{block: QuaternionIntegrator, rate: w, initial: [{}, 0, 0, {}]}}\n", 3.0 * size, 4.0 * size);
    CHECK(value_of(rate + start, "y.1") == Approx(0.6));
    CHECK(value_of(rate + start, "y.4") == Approx(0.8));
  }
}

TEST_CASE("a direction, a resistance and the power of lines count whatever their size") {
  for (const double size : sizes) {
    INFO(size);
    const std::string motion =
        "  y: {{block: StraightMotion, from: [0, 0], direction: [{}, {}], speed: 10 m/s}}\n";
    CHECK(value_of(fmt::format(fmt::runtime(motion), 3.0 * size, 4.0 * size), "y.velocity.2", "y.velocity") ==
          Approx(8.0));
    const std::string force = fmt::format("  f: {{block: Constant, value: {{value: [{}, {}], unit: N}}}}\n",
                                          -3.0 * size, -4.0 * size);
    const std::string most = fmt::format("  m: {{block: Constant, value: {{value: [{}, {}], unit: N}}}}\n",
                                         3.0 * size, 4.0 * size);
    CHECK(value_of(force + most + "  y: {block: Directionality, f_max: m, force: f}\n", "y.y.2", "y.y") ==
          Approx(4.0 * size));
    const std::string lines =
        "  y: {{block: Multisine, frequencies: [1 Hz], phase: zero, amplitude: {}, rms: 3}}\n";
    CHECK(value_of(fmt::format(fmt::runtime(lines), size), "y") == Approx(3.0 * std::sqrt(2.0)));
    CHECK(length(Vector2{3.0 * size, 4.0 * size}) == Approx(5.0 * size));
    CHECK(length(Vector3{2.0 * size, 3.0 * size, -6.0 * size}) == Approx(7.0 * size));
  }
}
