#pragma once

#include <string>

#include "engine/app/cli/exit_code.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::cli {

/// A unit of FMI that is made of a diagram file.
struct UnitCall {
  std::string file;
  std::string out;  ///< the unit's file
  std::string name;
  int version = 3;
};

/// Makes it, and says what is to be known of it.
ExitCode generate_unit(const UnitCall& call, const Registry& registry, const session::LoadedModel& model,
                       const codegen::Tuning& tuning);

}  // namespace stepwire::cli
