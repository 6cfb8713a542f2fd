#include <catch2/catch.hpp>
#include <cmath>

#include "blocks/sources/chirp.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("the phase of a chirp is the integral of its frequency") {
  Chirp chirp;
  chirp.frequency = 2.0;
  chirp.target_frequency = 18.0;
  chirp.target_time = 4.0;
  SECTION("linear: the mean of both frequencies") {
    REQUIRE(chirp.cycles(4.0) == Approx(40.0));
  }
  SECTION("exponential: (f1 - f0) T / ln(f1 / f0)") {
    chirp.sweep = Chirp::Sweep::exponential;
    REQUIRE(chirp.cycles(4.0) == Approx(64.0 / std::log(9.0)));
    REQUIRE((chirp.cycles(2.001) - chirp.cycles(1.999)) / 0.002 ==
            Approx(6.0).epsilon(1e-6));  // geometric mean
  }
  SECTION("after the target time the frequency stays") {
    REQUIRE(chirp.cycles(5.5) - chirp.cycles(4.5) == Approx(18.0));
  }
}

TEST_CASE("a linear chirp is sin(2 pi (f0 t + (f1 - f0) t^2 / 2 T))") {
  const table::Table run = run_text(R"(
step: 1 ms
stop: 2 s
blocks:
  y: {block: Chirp, amplitude: 3, frequency: 1 Hz, target_frequency: 5 Hz, target_time: 2 s, bias: 1}
record: [y]
)");
  const auto &time = column(run, "time"), &y = column(run, "y");
  for (std::size_t i = 0; i < y.size(); ++i)
    REQUIRE(y[i] == Approx(1.0 + 3.0 * std::sin(2.0 * M_PI * (time[i] + time[i] * time[i]))).margin(1e-12));
}

TEST_CASE("an exponential chirp from zero is refused") {
  const std::string error = error_of(R"(
step: 1 ms
stop: 1 s
blocks:
  y: {block: Chirp, sweep: exponential, frequency: 0 Hz}
record: [y]
)");
  REQUIRE_THAT(error, Catch::Contains("y.frequency") && Catch::Contains("above 0"));
}
