#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/formula.hpp"
#include "engine/analyse/query/series.hpp"
#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/key.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::estimation {

/// A fitted parameter of the diagram. Numbers are SI.
struct FitParameter {
  static constexpr double open = std::numeric_limits<double>::infinity();

  std::string name;  ///< Name as in --set: "rig.beta".
  double start = 0.0;
  double lower = -open, upper = open;
  double scale = 1.0;        ///< Typical change, above 0.
  bool each_record = false;  ///< True: each record has its own value.
  std::optional<unit::Dimension> dimension{};
  std::string unit{};  ///< Unit in which the value is shown, as the author wrote it; empty: SI.
  yaml::Place place{};

  bool bounded() const { return lower > -open && upper < open; }
};

/// Values of all fitted parameters for one record.
using Values = std::vector<double>;

inline Values start_of(const std::vector<FitParameter>& parameters) {
  Values start;
  for (const FitParameter& parameter : parameters) start.push_back(parameter.start);
  return start;
}

/// A comparison with a record: residuals are weight (model - measured) in the rows where `where` holds.
struct FitComparison {
  query::Series model;
  query::Formula measured;
  std::optional<query::Formula> weight,
      where;  ///< Evaluated in the run with the start values. Without them: weight 1, all rows.
  bool free_offset = false;  ///< True: the weighted mean of the difference is no error, in each record.
  std::size_t recording = 0;
  yaml::Place place;
  std::vector<query::Series> against{};  ///< Additional abscissas of its pictures, besides time.
};

/// A function of the fitted parameters and a variable, such as alpha over the current.
struct FitCurve {
  query::Series y;                ///< Expression in shared parameters and the variable.
  std::vector<double> otherwise;  ///< Values of columns that the call sets and the fit does not change.
  std::string variable;           ///< Name of the variable; it has no unit.
  double from = 0.0, to = 1.0;    ///< Range of the variable.
  std::string label;              ///< Label of its axis.
  std::optional<query::Formula>
      data;                   ///< Expression of the variable in the records (SI); its range is shown.
  std::size_t recording = 0;  ///< Index of the recording with the data.
  yaml::Place place{};
};

/// Loss function of residuals that are large compared with `width`.
enum class FitLoss { none, huber, cauchy };

/// Kind of the standard errors of intervals. Automatic: serial for a time series, else classical.
enum class StandardErrors { automatic, classical, serial };

/// Differential evolution before the least squares.
struct GlobalSearch {
  std::size_t population = 40, generations = 60;
};

/// The section `fit` of a diagram file.
struct FitRequest {
  std::vector<FitParameter> parameters;
  std::vector<FitComparison> comparisons;
  std::vector<FitCurve> curves{};
  std::optional<query::Formula> hold_out;  ///< Swept parameters of records that are predicted, not fitted.
  FitLoss loss = FitLoss::none;
  double width = 1.0;      ///< Width of the loss, in weighted residuals.
  std::size_t starts = 1;  ///< The first start is the given one, the others are random within the bounds.
  std::optional<std::size_t> follow;  ///< Starts that continue after the first steps; default: a quarter.
  std::uint64_t seed = 1;
  std::size_t iterations = 200;  ///< Limit for each start.
  double tolerance = 1e-8;       ///< Change of an unknown at which a search ends; see refine().
  StandardErrors standard_errors = StandardErrors::automatic;
  std::string records = "record";  ///< Name of the records in pictures: measured, simulated.
  std::optional<GlobalSearch> global;
  yaml::Place place;
};

/// Returns the schema of the section `fit`.
const yaml::Key& fit_form();

/// Reads the value under the key `fit`. Adds all faults to `faults`; with faults the result must not be used.
FitRequest read_fit(const yaml::Node& node, const query::SymbolTable& names, const diagram::Diagram& diagram,
                    yaml::Faults& faults);

}  // namespace stepwire::estimation
