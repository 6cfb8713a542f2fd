#include "tests/engine/analyse/tuning/tune_text.hpp"

#include <catch2/catch.hpp>

#include "blocks/register.hpp"
#include "engine/app/session/loaded_model.hpp"

namespace stepwire {

tuning::TuneResult tune_text(const std::string& yaml, plan::CodeSource* code,
                             const tuning::TuneOptions& options, const std::atomic<bool>* interrupt) {
  static const Registry registry = blocks();
  const std::string file = "tune.yaml";
  diagram::Loader loader(registry);
  loader.add(yaml::parse_document("stepwire: 1\ntitle: test\n" + yaml, file));
  const session::LoadedModel model = session::load_model(loader, file, {});
  REQUIRE(model.tune);
  return tuning::tune({loader, file, {}, model.linear, code, interrupt}, model.job, *model.tune, options);
}

std::string tune_error(const std::string& yaml) {
  try {
    tune_text(yaml);
  } catch (const yaml::Error& error) {
    return error.what();
  }
  return "";
}

double tuned(const tuning::TuneResult& result, const std::string& name) {
  for (const tuning::TunedNumber& number : result.numbers)
    if (number.name == name) return number.value;
  FAIL("nothing was found for " << name);
  return 0.0;
}

std::string cost_of(const std::string& expression, const std::string& tune) {
  return R"(step: 1 s
stop: 1 s
parameters:
  a: {value: 2, doc: x}
  b: {value: 1, doc: x}
  c: {value: 0, doc: x}
blocks:
  a_: {block: Constant, value: $a}
  b_: {block: Constant, value: $b}
  c_: {block: Constant, value: $c}
  cost: {block: Expression, u: [a_, b_, c_], expression: ")" +
         expression + R"("}
record: [cost, a_, b_]
tune:
)" + tune;
}

std::string second_order(const std::string& tune) {
  return R"(step: 10 ms
stop: 30 s
solver: rk4
parameters:
  zeta: {value: 0.9, above: 0, doc: damping ratio}
blocks:
  plant: {block: TransferFunction, u: 1, numerator: [1], denominator: [1, = 2*zeta, 1]}
  clock: {block: Ramp, slope: 1}
  e: {block: Expression, u: plant, expression: 1 - u1}
  e2: {block: Expression, u: e, expression: u1*u1}
  te2: {block: Expression, u: [clock, e2], expression: u1*u2}
  te: {block: Expression, u: [clock, e], expression: u1*abs(u2)}
  ise: {block: Integrator, u: e2}
  itse: {block: Integrator, u: te2}
  itae: {block: Integrator, u: te}
record: [plant, ise, itse, itae]
tune:
  parameters: {zeta: {from: 0.1, to: 2}}
)" + tune;
}

}  // namespace stepwire
