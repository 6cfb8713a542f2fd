#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/app/python/loaded_file.hpp"

namespace stepwire::python {

/// What a tuning found, with the model that it was of. Never changes.
struct Tuning {
  File file{};
  tuning::TuneResult result{};
  std::vector<std::string> notes{};
};

/// Finds the parameters of the section `tune`. The lock is held.
std::shared_ptr<Tuning> tune_call(const std::shared_ptr<LoadedFile>& of, const session::TuneCall& request,
                                  _object* progress);

/// Adds the class `Tuning`.
void add_tunings(_object* module);

}  // namespace stepwire::python
