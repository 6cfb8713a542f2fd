#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/app/python/loaded_file.hpp"

namespace stepwire::python {

/// What a fit found, with the model that it was of. Never changes.
struct Fit {
  File file{};
  estimation::FitResult result{};
  std::vector<session::FitPicture> pictures{};
  std::vector<std::string> notes{};
};

/// Finds the parameters of the section `fit`. The lock is held.
std::shared_ptr<Fit> fit_call(const std::shared_ptr<LoadedFile>& of, const std::string& engine,
                              std::optional<std::size_t> starts, std::optional<std::uint64_t> seed,
                              unsigned threads, _object* progress);

/// Adds the class `Fit`.
void add_fits(_object* module);

}  // namespace stepwire::python
