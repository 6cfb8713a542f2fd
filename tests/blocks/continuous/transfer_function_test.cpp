#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

const std::string head = "step: 1 ms\nstop: 4 s\nsolver: rk4\nblocks:\n";

std::vector<double> response(const std::string& keys) {
  return column(run_text(head + "  g: {block: TransferFunction, " + keys + "}\nrecord: [g]\n"), "g");
}

}  // namespace

// scipy 1.10.1: signal.step(([1, 3], [1, 2.5, 4, 2]), T=linspace(0, 4, 4001)), at 0, 0.5, 1, 2, 4 s
TEST_CASE("The step response of a third-order transfer function agrees with SciPy") {
  const auto y = response("numerator: [1, 3], denominator: [1, 2.5, 4, 2], u: 1");
  CHECK(y[0] == 0.0);
  CHECK(y[500] == Approx(0.12403444806320048).epsilon(1e-10));
  CHECK(y[1000] == Approx(0.4338874483397401).epsilon(1e-10));
  CHECK(y[2000] == Approx(1.0843684759571053).epsilon(1e-10));
  CHECK(y[4000] == Approx(1.4367763125423827).epsilon(1e-10));
}

// An impulse sets the first state of the canonical form to 1.
// scipy 1.10.1: signal.impulse(([2, 1], [1, 0.4, 9]), T=linspace(0, 4, 4001)), at 0, 0.5, 1, 2, 4 s
TEST_CASE("The impulse response of a resonator agrees with SciPy") {
  const auto y = response("numerator: [2, 1], denominator: [1, 0.4, 9], u: 0, initial: [1, 0]");
  CHECK(y[0] == 2.0);
  CHECK(y[500] == Approx(0.31490727095236604).epsilon(1e-9));
  CHECK(y[1000] == Approx(-1.5952530835795113).epsilon(1e-9));
  CHECK(y[2000] == Approx(1.2428663306603702).epsilon(1e-9));
  CHECK(y[4000] == Approx(0.6948559001273125).epsilon(1e-9));
}

TEST_CASE("Equal degrees pass the input straight through") {
  const auto y = response("numerator: [2, 8], denominator: [2, 2], u: 1");  // 1 + 3 / (s + 1)
  for (std::size_t k = 0; k < y.size(); k += 100)
    CHECK(y[k] == Approx(4.0 - 3.0 * std::exp(-1e-3 * static_cast<double>(k))).epsilon(1e-11));
  CHECK_THAT(
      error_of(head + "  g: {block: TransferFunction, numerator: [1, 2], denominator: [1, 1], u: g}\n"),
      Catch::Contains("loop"));
  CHECK(error_of(head + "  g: {block: TransferFunction, numerator: [0, 2], denominator: [1, 1], u: g}\n")
            .empty());
}

TEST_CASE("A settled sine has the amplitude and phase of the transfer function") {
  const table::Table table = run_text(head + R"(  u: {block: Sine, frequency: 2}
  g: {block: TransferFunction, numerator: [3, 50], denominator: [1, 12, 100], u: u}
record: [g]
)");
  const std::complex<double> s(0.0, 4.0 * std::acos(-1.0));
  const std::complex<double> h = (3.0 * s + 50.0) / (s * s + 12.0 * s + 100.0);
  for (std::size_t k = 3500; k <= 4000; k += 25) {  // the transient has fallen to exp(-6 t) < 1e-9
    const double t = 1e-3 * static_cast<double>(k);
    CHECK(column(table, "g")[k] == Approx(std::imag(h * std::exp(s * t))).margin(2e-7));
  }
}

TEST_CASE("A transfer function refuses what is not proper") {
  const auto refused = [](const std::string& keys) {
    return error_of(head + "  g: {block: TransferFunction, u: 1, " + keys + "}\n");
  };
  CHECK_THAT(refused("numerator: [1, 0, 0], denominator: [1, 1]"),
             Catch::Contains("the numerator has degree 2 and the denominator 1"));
  CHECK_THAT(refused("denominator: [0, 1, 1]"), Catch::Contains("first coefficient is 0"));
  CHECK_THAT(refused("denominator: [2]"), Catch::Contains("Gain"));
}
