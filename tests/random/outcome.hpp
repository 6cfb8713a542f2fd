#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/simulate/run/run.hpp"
#include "tests/random/sketch.hpp"

namespace stepwire::random {

/// A sketch that the loader has taken, with what it was loaded by.
class Loaded {
 public:
  /// Data files and parts are looked for in the folder. Throws yaml::Error.
  Loaded(const Registry& registry, const Sketch& sketch, const std::string& folder,
         const std::vector<diagram::Setting>& settings = {});
  /// The same for the text of a single file.
  Loaded(const Registry& registry, const std::string& text, const std::string& folder);

  const plan::Plan& plan() const { return job->plan; }
  const run::Job& all() const { return *job; }

 private:
  std::unique_ptr<diagram::Loader> loader_;
  std::unique_ptr<run::Job> job;
};

/// Column names of one diagram, as another one has them.
using OtherName = std::function<std::string(const std::string&)>;

/// The first number in which two runs differ, as a sentence; empty if all bits of all columns agree. Columns
/// of `other` that `expected` lacks do not count.
std::string difference(const run::RunResult& expected, const run::RunResult& other,
                       const OtherName& name_in_other = {});

}  // namespace stepwire::random
