// Fits of measured and published records, which the data folder has.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "blocks/register.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/engine/analyse/estimation/fit_text.hpp"

namespace stepwire::estimation {

namespace {

bool there() {
  if (std::getenv("STEPWIRE_DATA")) return true;
  WARN("skipped: STEPWIRE_DATA names no data folder");
  return false;
}

/// Fits an example, with its request changed.
FitResult fit_example(const std::string& name, const std::function<void(FitRequest&)>& change = {}) {
  static const Registry registry = blocks();
  const std::string file = STEPWIRE_SOURCE_DIR "/diagrams/examples/" + name;
  diagram::Loader loader(registry);
  session::LoadedModel model = session::load_model(loader, file, {});
  REQUIRE(model.fit);
  if (change) change(*model.fit);
  codegen::GeneratedCode code{run::code_trial()};
  return fit({loader, file, {}, &code}, model.job, *model.fit);
}

double worst_agreement(const FitResult& result) {
  double worst = 100.0;
  for (const FittedRecord& record : result.records)
    worst = std::min(worst, record.comparisons.at(0).agreement);
  return worst;
}

/// Holds out the records of one motion of the press.
void hold_out(FitRequest& request, bool first) {
  const expression::Expression condition(first ? "name < 5" : "name >= 5");
  request.hold_out = query::Formula{"", condition, {"name"}, std::nullopt, std::nullopt, {}};
}

}  // namespace

TEST_CASE("one damper model describes all ten records of the press to 90 %", "[full]") {
  if (!there()) return;
  const FitResult result = fit_example("61-fit-press.yaml");
  CHECK(result.converged);
  CHECK(result.compiled);
  CHECK(worst_agreement(result) >= 90.0);
  CHECK(result.findings.empty());
}

TEST_CASE("either motion of the press predicts the other to 87 %", "[full]") {
  if (!there()) return;
  for (const bool first : {true, false})
    CHECK(worst_agreement(fit_example("61-fit-press.yaml",
                                      [&](FitRequest& request) { hold_out(request, first); })) >= 87.0);
}

TEST_CASE("the parameters of the Bouc-Wen benchmark are found to 1 % from its noisy record", "[full]") {
  if (!there()) return;
  const FitResult result = fit_example("62-fit-benchmark.yaml");
  const std::vector<std::pair<std::string, double>> truth{{"m", 2.0}, {"c", 10.0}, {"k", 5e4},
                                                          {"a", 5e4}, {"g", 0.8},  {"d", -1.1}};
  for (const auto& [name, value] : truth) {
    INFO(name);
    CHECK(found(result, name).value == Approx(value).epsilon(0.01));
  }
}

}  // namespace stepwire::estimation
