#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/app/python/loaded_file.hpp"

namespace stepwire::python {

/// Immutable result of a search for parameters, a fit or an optimisation.
struct Found {
  std::string json{}, words{};
  std::vector<diagram::Setting> settings{};  ///< the parameters that were found
  std::vector<session::FitPicture> pictures{};
  std::vector<tuning::Evaluation> history{};  ///< of an optimisation
  std::vector<std::string> notes{};
};

/// Estimates the parameters of the section `fit`. The caller must hold the interpreter lock.
std::shared_ptr<Found> fit_call(const File& of, const session::FitCall& request, _object* progress);

/// Optimises the parameters of the section `tune`. The caller must hold the interpreter lock.
std::shared_ptr<Found> tune_call(const File& of, const session::TuneCall& request, _object* progress);

void add_found(_object* module);

}  // namespace stepwire::python
