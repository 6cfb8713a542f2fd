#include "tests/random/batch_units.hpp"

#include <fmt/format.h>

#include <vector>

#include "engine/app/fmu/unit_export.hpp"
#include "engine/base/archive/archive.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/flatten.hpp"

namespace stepwire::random {

const MadeUnit* BatchUnits::unit(const plan::Plan& plan, int version) {
  const std::string key = fmt::format("{} {}", version, diagram::flattened_text(plan.diagram));
  auto [found, is_new] = wanted_.try_emplace(key);
  Wanted& wanted = found->second;
  if (is_new) wanted = {&plan, version, {.file = fmt::format("{}/{}.fmu", folder_.path(), count_++)}};
  return wanted.made.done ? &wanted.made : nullptr;
}

void BatchUnits::make_all(const codegen::Compiler& compiler) {
  std::vector<Wanted*> open;
  for (auto& [key, wanted] : wanted_)
    if (!wanted.made.done) open.push_back(&wanted);
  parallel::in_parallel(open.size(), 0, [&](std::size_t i) { make(*open[i], compiler); });
}

void BatchUnits::make(Wanted& wanted, const codegen::Compiler& compiler) {
  MadeUnit& made = wanted.made;
  made.done = true;
  try {
    const fmu::UnitExport unit = fmu::export_unit(
        *wanted.plan, codegen::tuning_of(*wanted.plan),
        {.version = wanted.version, .name = "unit", .made_by = "a test", .flags = {"-O0"}}, compiler);
    made.exchanges = unit.no_exchange.empty();
    io::write_file(made.file, archive::archive_bytes(unit.files));
  } catch (const yaml::Error& error) {
    made.refused = error.what();
  } catch (const io::EnvironmentError& error) {
    made.problem = error.what();
  }
}

}  // namespace stepwire::random
