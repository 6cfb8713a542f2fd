#include "tests/engine/analyse/estimation/fit_text.hpp"

#include <catch2/catch.hpp>

#include "blocks/register.hpp"
#include "engine/app/session/loaded_model.hpp"

namespace stepwire {

estimation::FitResult fit_text(const std::string& yaml, plan::CodeSource* code,
                               const estimation::FitOptions& options) {
  static const Registry registry = blocks();
  const std::string file = "fit.yaml";
  diagram::Loader loader(registry);
  loader.add(yaml::parse_document("stepwire: 1\ntitle: test\n" + yaml, file));
  const session::LoadedModel model = session::load_model(loader, file, {});
  REQUIRE(model.fit);
  return estimation::fit({loader, file, {}, code}, model.job, *model.fit, options);
}

std::string fit_error(const std::string& yaml) {
  try {
    fit_text(yaml);
  } catch (const yaml::Error& error) {
    return error.what();
  }
  return "";
}

const estimation::FittedNumber& found(const estimation::FitResult& result, const std::string& name) {
  for (const estimation::FittedNumber& number : result.numbers)
    if (number.title() == name) return number;
  FAIL("nothing was found for " << name);
  return result.numbers.front();
}

std::string straight_line(const std::string& fit) {
  return R"(step: 1 s
stop: 7 s
parameters:
  slope: {value: 1, doc: of the line}
  bias: {value: 0, doc: of the line}
blocks:
  t: {block: Ramp, slope: 1}
  model: {block: Sum, u: [steep, level]}
  steep: {block: Gain, u: t, gain: $slope}
  level: {block: Constant, value: $bias}
  y: {block: LookupTable, u: t, points: [0, 1, 2, 3, 4, 5, 6, 7], values: [1.1, 2.9, 5.2, 6.8, 9.1, 11.2, 12.8, 15.1]}
record: [model, y, steep]
fit:
)" + fit;
}

}  // namespace stepwire
