#pragma once

#include <string>

#include "engine/app/cli/exit_code.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::cli {

/// Options for exporting a diagram file as an FMI unit.
struct UnitCall {
  std::string file;
  std::string out;  ///< path of the unit
  std::string name;
  int version = 3;
};

/// Exports the unit and prints notes on it.
ExitCode generate_unit(const UnitCall& call, const Registry& registry, const session::LoadedModel& model,
                       const codegen::Tuning& tuning);

}  // namespace stepwire::cli
