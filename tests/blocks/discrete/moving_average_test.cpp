#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A moving average is the mean of the last samples, taken anew for each") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 200 ms
blocks:
  a: {block: Sine, frequency: 23, amplitude: 1000}
  b: {block: Clock}
  u: {block: Mux, u: [a, b]}
  mean: {block: MovingAverage, u: u, window: 7 ms}
record: [u, mean]
)");
  for (const std::string element : {".1", ".2"}) {
    const auto& u = column(table, "u" + element);
    for (std::size_t k = 0; k < table.rows(); ++k) {
      const std::size_t first = k < 6 ? 0 : k - 6;
      double sum = 0.0;
      for (std::size_t i = first; i <= k; ++i) sum += u[i];
      CHECK(column(table, "mean" + element)[k] ==
            Approx(sum / static_cast<double>(k - first + 1)).margin(1e-10));
    }
  }
}

TEST_CASE("A moving average over a period of the mains removes its hum, even after a million samples") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1000 s
blocks:
  hum: {block: Sine, frequency: 50, bias: 0.1}
  mean: {block: MovingAverage, u: hum, window: 20 ms}
record: {every: 1 s, signals: [mean]}
)");
  for (std::size_t k = 1; k < table.rows(); ++k) CHECK(column(table, "mean")[k] == Approx(0.1).margin(1e-9));
}

TEST_CASE("A moving average of one sample is the sample") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 10 ms
blocks:
  t: {block: Clock}
  mean: {block: MovingAverage, u: t, window: 1 ms}
record: [mean]
)");
  CHECK(column(table, "mean") == column(table, "time"));
}
