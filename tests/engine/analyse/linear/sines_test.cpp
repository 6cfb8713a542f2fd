#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/analyse/linear/frequency_response.hpp"
#include "engine/analyse/linear/linearize.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::linear {

namespace {

/// A loop with a lag, two rates, a delay and a kink far away, driven by a sine.
std::string driven(double frequency) {
  return "stepwire: 1\ntitle: x\nstep: 0.5 ms\nstop: 12 s\nsolver: rk4\nblocks:\n"
         "  r: {block: Sine, amplitude: 0.01, frequency: " +
         std::to_string(frequency) +
         " Hz}\n"
         "  held: {block: ZeroOrderHold, u: r, every: 5 ms}\n"
         "  e: {block: Sum, signs: \"+-\", u: [held, late]}\n"
         "  c: {block: DiscretePID, u: e, kp: 3, ki: 10 1/s, every: 5 ms, lower: -5, upper: 5}\n"
         "  p: {block: TransferFunction, u: c, numerator: [2], denominator: [0.02, 0.3, 1]}\n"
         "  late: {block: Delay, u: p, delay: 10 ms, every: 5 ms}\n"
         "record: {every: 5 ms, signals: [held, late]}\n";
}

/// The amplitude of a frequency in whole periods at the end of a record.
std::complex<double> part_of(const std::vector<double>& signal, double frequency, double period) {
  const auto rows = static_cast<std::size_t>(std::lround(4.0 / period));
  std::complex<double> sum = 0.0;
  for (std::size_t i = signal.size() - rows; i < signal.size(); ++i)
    sum += signal[i] * std::polar(1.0, -2.0 * std::numbers::pi * frequency * static_cast<double>(i) * period);
  return sum;
}

}  // namespace

TEST_CASE("a sweep of sines through the diagram has the gain and phase of its linear system") {
  const DiagramFolder folder;
  folder.write("a.yaml", driven(1.0));
  diagram::Loader loader(library());
  Request request;
  request.from = {{"held"}};
  request.to = {{"late"}};
  const FrequencyResponse response(linearize(loader.load(folder.path("a.yaml")), request).system);
  for (const double frequency : {0.5, 2.0, 5.0, 20.0}) {
    const table::Table table = run_text(driven(frequency));
    const auto measured =
        part_of(column(table, "late"), frequency, 0.005) / part_of(column(table, "held"), frequency, 0.005);
    const auto computed = response.at(2.0 * std::numbers::pi * frequency);
    INFO(frequency << " Hz: " << std::abs(measured) << " and " << std::abs(computed));
    CHECK(20.0 * std::abs(std::log10(std::abs(measured) / std::abs(computed))) < 3e-4);  // dB
    CHECK(std::abs(std::arg(measured / computed)) < 1e-4);
  }
}

}  // namespace stepwire::linear
