#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "blocks/register.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"

namespace stepwire::broken {

/// Runs, fits and makes studies as the gallery does, and judges claims.
class Runner {
 public:
  /// The verdicts of a file. Throws yaml::Error where it cannot be loaded, or a run ends by a fault.
  std::vector<claim::Verdict> verdicts(const std::string& file,
                                       const std::vector<diagram::Setting>& settings);
  /// The verdicts of the claims that read pictures, on the same rows with another section `figure`; a claim
  /// that cannot be read with it fails.
  /// Throws yaml::Error where the section is refused.
  std::vector<claim::Verdict> verdicts_with(const yaml::Node& figure);
  /// A picture of that section as a text; by its index.
  std::string picture_with(const yaml::Node& figure, std::size_t picture);

  /// True if the labels and titles of that section disagree with what it draws.
  bool has_wrong_texts(const yaml::Node& figure) const;

  bool takes_long() const { return takes_long_; }
  /// The model and the outcome of the last call of verdicts().
  const session::LoadedModel& model() const { return *model_; }
  const session::Outcome& outcome() const { return outcome_; }
  bool sweeps(const std::string& parameter) const { return swept_.contains(parameter); }

 private:
  session::LoadedModel loaded_with(const yaml::Node& figure) const;
  void run();

  const Registry registry_ = blocks();
  codegen::GeneratedCode code_{run::code_trial()};
  session::Studies studies_;
  std::optional<session::LoadedModel> model_;
  session::Outcome outcome_;
  bool takes_long_ = false;
  std::set<std::string> swept_;
};

}  // namespace stepwire::broken
