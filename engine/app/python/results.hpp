#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/app/python/loaded_file.hpp"
#include "engine/app/session/outcome.hpp"

namespace stepwire::python {

/// What a run, a sweep or a study left, with the model that it was of. Never changes.
struct Results {
  std::shared_ptr<const session::LoadedModel> model;
  session::Outcome outcome{};
  std::vector<std::string> notes{};  ///< such as why nothing was compiled
  std::string study{};               ///< all that a study found, as JSON; empty for a run
  std::string words{};               ///< for people
  Held raised{};                     ///< by an observer, or an interruption; null: nothing
  Held cause{};                      ///< raised by a block, whose fault is among those of the run
};

/// Adds the class `Results`.
void add_results(_object* module);

}  // namespace stepwire::python
