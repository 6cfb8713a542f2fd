#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/run_formula.hpp"
#include "engine/analyse/linear/section.hpp"
#include "engine/analyse/query/symbol_table.hpp"
#include "engine/analyse/tuning/tune_parameter.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::tuning {

/// Methods of NLopt. M. J. D. Powell 1994 (COBYLA), 2009 (BOBYQA); T. Runarsson, X. Yao 2005 (ISRES);
/// T. Rowan 1990 (Subplex). Least squares of targets is by Ceres.
enum class TuneMethod { automatic, bobyqa, cobyla, isres, subplex, least_squares };

/// What counts of the objectives of several runs.
enum class TuneOver { worst, mean };

/// The section `tune` of a diagram file.
struct TuneRequest {
  std::vector<TuneParameter> parameters;
  claim::RunFormula minimise{};         ///< without a formula where there are targets
  std::vector<claim::Claim> targets{};  ///< `toward`: each equals a value, within its deviation
  std::vector<claim::Claim> constraints{};
  TuneOver over = TuneOver::worst;
  TuneMethod method = TuneMethod::automatic;
  std::size_t starts = 1;  ///< the first is the given one, the others are random within the bounds
  std::uint64_t seed = 1;
  std::size_t evaluations = 500;              ///< of one start, at most
  std::optional<std::size_t> experiments{};   ///< of a study, in one evaluation
  std::optional<std::uint64_t> study_seed{};  ///< of these experiments
  double tolerance = 1e-4;  ///< change of a parameter that no longer counts, as a share of its range
  yaml::Place place{};

  /// The method that counts: the file's, or the one that the problem calls for.
  TuneMethod chosen_method() const;
  /// The text of `minimise`, or words for targets.
  std::string objective_text() const;
  std::optional<unit::Dimension> objective_dimension() const;
  /// Targets and claims.
  std::vector<const claim::Claim*> claims() const;
};

/// The keys of the section `tune`.
const yaml::Key& tune_form();

/// Reads the value under the key `tune`. Everything that is wrong goes to `faults`; what is returned then is
/// of no use.
TuneRequest read_tune(const yaml::Node& node, const query::SymbolTable& names,
                      const diagram::Diagram& diagram, const std::vector<linear::NamedAnalysis>& linear,
                      yaml::Faults& faults);

}  // namespace stepwire::tuning
