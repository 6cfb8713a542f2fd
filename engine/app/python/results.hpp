#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/app/python/loaded_file.hpp"
#include "engine/app/session/outcome.hpp"

namespace stepwire::python {

/// Immutable results of a run, a sweep or a study, with the model.
struct Results {
  std::shared_ptr<const session::LoadedModel> model;
  session::Outcome outcome{};
  std::vector<std::string> notes{};  ///< Notes such as the reason for not compiling.
  std::string study{};               ///< Results of a study as JSON; empty for a run.
  std::string words{};               ///< Results as text for the terminal.
  Held raised{};                     ///< Exception of an observer, or an interruption; nullptr if none.
  Held cause{};                      ///< Exception of a block, whose fault is also in the outcome.
};

void add_results(_object* module);

}  // namespace stepwire::python
