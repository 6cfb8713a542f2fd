// Units that do something wrong: in a process of their own that is a fault of the block, and nowhere another
// number.
#include <fmt/format.h>
#include <xmmintrin.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cfenv>
#include <cmath>
#include <cstdlib>

#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"
#include "tests/support/units/units.hpp"

using namespace stepwire;

namespace {

using Catch::Contains;

/// A diagram of one unit beside blocks of ours, whose numbers are rounded and, in `tiny`, denormal.
std::string bad_diagram(const Scratch& scratch, int version, const std::string& deed,
                        const std::string& keys) {
  const std::string path = testing::write_zip(scratch.path("bad.fmu"), testing::bad_unit(version, deed));
  return fmt::format(R"(
step: 10 ms
stop: 1 s
solver: rk4
events: locate
blocks:
  unit: {{block: Fmu, file: {}{}}}
  wave: {{block: Sine, amplitude: 1, frequency: 3 Hz}}
  third: {{block: Gain, u: wave, gain: 0.1}}
  sum: {{block: Sum, u: [third, unit.y]}}
  lag: {{block: Lag, u: third, tau: 0.3 s}}
  tiny: {{block: Gain, u: wave, gain: 1e-310}}
record: [wave, third, sum, lag, tiny]
)",
                     path, keys);
}

std::string fault_of(int version, const std::string& deed, const std::string& keys = "") {
  const Scratch scratch;
  return error_of(bad_diagram(scratch, version, deed, keys));
}

/// Seconds that a unit may take, within a scope.
struct Limit {
  explicit Limit(const char* seconds) { ::setenv("STEPWIRE_HELPER_LIMIT", seconds, 1); }
  ~Limit() { ::unsetenv("STEPWIRE_HELPER_LIMIT"); }
};

}  // namespace

TEST_CASE("a unit that ends its own process is a fault of the block that names the call and the status") {
  for (const int version : {2, 3})
    for (const std::string deed : {"exit", "quick_exit", "_exit"}) {
      const std::string fault = fault_of(version, deed + " DoStep");
      INFO(fault);
      CHECK_THAT(fault,
                 Contains(fmt::format("its process in fmi{}DoStep has ended itself with status 0", version)));
      CHECK_THAT(fault, Contains("unit"));
    }
  CHECK_THAT(fault_of(3, "_exit Instantiate"), Contains("in fmi3InstantiateCoSimulation has ended itself"));
  CHECK_THAT(fault_of(2, "exit Initialize"), Contains("in fmi2SetupExperiment has ended itself"));
  CHECK_THAT(fault_of(3, "throw DoStep"), Contains("fmi3DoStep threw an exception"));
}

TEST_CASE("a unit that hangs or is stopped is ended behind the limit of helpers, in whatever call",
          "[full]") {
  const Limit limit("0.3");
  for (const int version : {2, 3}) {
    const std::string call = fmt::format("its process in fmi{}", version);
    for (const std::string deed : {"hang DoStep", "stop DoStep", "hang Initialize", "hang Instantiate"}) {
      const std::string fault = fault_of(version, deed);
      INFO(deed << ": " << fault);
      CHECK_THAT(fault,
                 Contains(call) && Contains("does not come to an end and was ended; STEPWIRE_HELPER_LIMIT"));
    }
  }
}

TEST_CASE("a status that FMI does not have is a fault") {
  for (const int version : {2, 3})
    for (const std::string keys : {"", ", isolate: false"})
      for (const int status : {-1, 6, 99}) {
        const std::string fault = fault_of(version, fmt::format("status{} DoStep", status), keys);
        CHECK_THAT(fault, Contains(fmt::format("fmi{}DoStep returned the status {}, which FMI does not have",
                                               version, status)));
      }
  CHECK_THAT(fault_of(3, "status3 DoStep"), Contains("fmi3DoStep failed"));
  CHECK_THAT(fault_of(2, "status5 DoStep"), Contains("fmi2DoStep failed"));
  CHECK(fault_of(3, "status1 DoStep").empty());
}

TEST_CASE("a last successful time that is no number, or that goes back, is refused") {
  for (const std::string deed : {"nan DoStep", "infinite DoStep", "backwards DoStep"})
    CHECK_THAT(fault_of(3, deed), Contains("as its last successful time, in the step from 0.24"));
}

TEST_CASE(
    "a unit that passes the end of a step by a part of its own step is taken, and one by more refused") {
  CHECK(fault_of(3, "beyond DoStep").empty());
  CHECK_THAT(fault_of(3, "far DoStep"),
             Contains("that must be a time up to there") && Contains("; write 'interface: model_exchange'"));
  const Scratch scratch;
  const run::RunResult result = result_of(bad_diagram(scratch, 3, "beyond DoStep", ""));
  CHECK(std::ranges::any_of(result.diagnostics, [](const auto& one) {
    return one.text.find("passes the ends of steps by a part of its own step") != std::string::npos;
  }));
}

TEST_CASE("an event of a unit at a time that is no number, or that is over, is refused") {
  for (const int version : {2, 3})
    for (const std::string deed : {"nan Update", "infinite Update", "backwards Update"})
      CHECK_THAT(fault_of(version, deed, ", interface: model_exchange"),
                 Contains("as the time of its next event, at 0.3 s; that must be a later time"));
}

TEST_CASE("an event indicator that is no finite number is refused") {
  for (const int version : {2, 3})
    for (const std::string deed : {"nan", "infinite"})
      CHECK_THAT(fault_of(version, deed + " GetEventIndicators", ", interface: model_exchange"),
                 Contains("its event indicator 1 is") && Contains("it must be a finite number"));
}

TEST_CASE("a unit that sets the floating-point state in whatever call changes no number of other blocks") {
  const Scratch scratch;
  for (const int version : {2, 3})
    for (const std::string keys : {", isolate: false", ", isolate: false, interface: model_exchange"}) {
      const auto right = run_text(bad_diagram(scratch, version, "nothing DoStep", keys));
      for (const std::string deed : {"upward", "flush"})
        for (const std::string call :
             {"Instantiate", "Initialize", "Get", "DoStep", "Update", "FreeInstance"}) {
          const auto run = run_text(bad_diagram(scratch, version, deed + " " + call, keys));
          INFO(version << keys << " " << deed << " " << call);
          for (const std::string name : {"wave", "third", "sum", "lag", "tiny"})
            CHECK(column(run, name) == column(right, name));
          CHECK(std::fegetround() == FE_TONEAREST);
          CHECK((_mm_getcsr() & 0x8040u) == 0u);
        }
      CHECK(std::fpclassify(column(right, "tiny")[5]) == FP_SUBNORMAL);
    }
}

TEST_CASE("a unit in the program and one in a process of its own have the same bits") {
  const Scratch scratch;
  for (const std::string interface : {"co_simulation", "model_exchange"}) {
    const auto inside =
        run_text(bad_diagram(scratch, 3, "nothing at all", ", isolate: false, interface: " + interface));
    const auto isolated = run_text(bad_diagram(scratch, 3, "nothing at all", ", interface: " + interface));
    CHECK(column(inside, "sum") == column(isolated, "sum"));
  }
}
