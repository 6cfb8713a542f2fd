#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/app/python/loaded_file.hpp"

namespace stepwire::python {

/// Immutable result of an optimisation, with its model.
struct Tuning {
  File file{};
  tuning::TuneResult result{};
  std::vector<std::string> notes{};
};

/// Optimises the parameters of the section `tune`. The caller must hold the interpreter lock.
std::shared_ptr<Tuning> tune_call(const std::shared_ptr<LoadedFile>& of, const session::TuneCall& request,
                                  _object* progress);

void add_tunings(_object* module);

}  // namespace stepwire::python
