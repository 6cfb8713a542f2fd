#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/run_formula.hpp"
#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/place.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::tuning {

/// Scale on which a parameter is searched.
enum class TuneScale { automatic, linear, logarithmic };

/// A tuned parameter of the diagram. Numbers are SI.
struct TuneParameter {
  std::string name;  ///< Name as in --set: "rig.kp".
  double start = 0.0, lower = 0.0, upper = 0.0;
  TuneScale scale = TuneScale::automatic;
  std::optional<unit::Dimension> dimension{};
  std::string unit{};  ///< Unit in which the value is shown, as the author wrote it; empty: SI.
  yaml::Place place{};

  /// True for a logarithmic scale. With TuneScale::automatic that is so if the bounds differ by more than a
  /// factor of ten.
  bool is_logarithmic() const;
  /// Converts a share of the way between the bounds, 0 to 1, to a value, and back.
  double at(double share) const;
  double share_of(double value) const;
};

/// Search methods, by NLopt: M. J. D. Powell 1994 (COBYLA), 2009 (BOBYQA); T. Runarsson, X. Yao 2005 (ISRES);
/// T. Rowan 1990 (Subplex). Least squares of targets is by Ceres.
enum class TuneMethod { automatic, bobyqa, cobyla, isres, subplex, least_squares };

/// Reduction of the objectives of several runs to one.
enum class TuneOver { worst, mean };

/// The section `tune` of a diagram file.
struct TuneRequest {
  std::vector<TuneParameter> parameters;
  claim::RunFormula minimise{};         ///< Without a formula if there are targets.
  std::vector<claim::Claim> targets{};  ///< `toward`: each equals a value, within its deviation.
  std::vector<claim::Claim> constraints{};
  TuneOver over = TuneOver::worst;
  TuneMethod method = TuneMethod::automatic;
  std::size_t starts = 1;  ///< The first start is the given one, the others are random within the bounds.
  std::uint64_t seed = 1;
  std::size_t evaluations = 500;              ///< Limit for each start.
  std::optional<std::size_t> experiments{};   ///< Number of experiments of a study in one evaluation.
  std::optional<std::uint64_t> study_seed{};  ///< Seed of these experiments.
  double tolerance =
      1e-4;  ///< Change of a parameter at which a search has converged, as a share of its range.
  yaml::Place place{};

  /// Returns the method of the file, or the default for the problem.
  TuneMethod chosen_method() const;
  /// Returns the text of `minimise`, or a description of the targets.
  std::string objective_text() const;
  std::optional<unit::Dimension> objective_dimension() const;
  /// Returns targets and claims.
  std::vector<const claim::Claim*> claims() const;
};

/// Returns the schema of the section `tune`.
const yaml::Key& tune_form();

/// Reads the value under the key `tune`. Adds all faults to `faults`; with faults the result must not be
/// used.
TuneRequest read_tune(const yaml::Node& node, const query::SymbolTable& names,
                      const diagram::Diagram& diagram, const std::vector<linear::NamedAnalysis>& linear,
                      yaml::Faults& faults);

}  // namespace stepwire::tuning
