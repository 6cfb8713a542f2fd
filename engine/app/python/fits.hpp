#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/app/python/loaded_file.hpp"

namespace stepwire::python {

/// Immutable result of a fit, with its model.
struct Fit {
  File file{};
  estimation::FitResult result{};
  std::vector<session::FitPicture> pictures{};
  std::vector<std::string> notes{};
};

/// Estimates the parameters of the section `fit`. The caller must hold the interpreter lock.
std::shared_ptr<Fit> fit_call(const std::shared_ptr<LoadedFile>& of, const std::string& engine,
                              std::optional<std::size_t> starts, std::optional<std::uint64_t> seed,
                              unsigned threads, _object* progress);

void add_fits(_object* module);

}  // namespace stepwire::python
