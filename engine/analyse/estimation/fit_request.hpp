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

/// A parameter of the diagram that a fit finds. Numbers are SI.
struct FitParameter {
  static constexpr double open = std::numeric_limits<double>::infinity();

  std::string name;  ///< as --set takes it: "rig.beta"
  double start = 0.0;
  double lower = -open, upper = open;
  double scale = 1.0;        ///< a change that counts, above 0
  bool each_record = false;  ///< each record has its own value
  std::optional<unit::Dimension> dimension{};
  std::string unit{};  ///< in which the author wrote it, for showing the value; empty: SI
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

/// What is compared: residuals are weight (model - measured) in the rows where `where` holds.
struct FitComparison {
  query::Series model;
  query::Formula measured;
  std::optional<query::Formula> weight,
      where;                 ///< of the run with the start values; weight 1 and all rows if absent
  bool free_offset = false;  ///< the weighted mean of the difference is no error, in each record
  std::size_t recording = 0;
  yaml::Place place;
  std::vector<query::Series> against{};  ///< what pictures show it over, beside the time
};

/// What follows from the fitted parameters as a function of something, such as alpha of the current.
struct FitCurve {
  query::Series y;                ///< of parameters that all records share, and of the variable
  std::vector<double> otherwise;  ///< values of its columns where they are not fitted but set by the call
  std::string variable;           ///< a bare number
  double from = 0.0, to = 1.0;    ///< of the variable
  std::string label;              ///< at its axis
  std::optional<query::Formula>
      data;                   ///< where the records have it (SI), as far as they tell anything of the curve
  std::size_t recording = 0;  ///< that has the data
  yaml::Place place{};
};

/// What residuals that are large beside `width` count.
enum class FitLoss { none, huber, cauchy };

/// Kind of the standard errors of intervals. Automatic: serial where the rows are a time series.
enum class StandardErrors { automatic, classical, serial };

/// Differential evolution ahead of the least squares.
struct GlobalSearch {
  std::size_t population = 40, generations = 60;
};

/// The section `fit` of a diagram file.
struct FitRequest {
  std::vector<FitParameter> parameters;
  std::vector<FitComparison> comparisons;
  std::vector<FitCurve> curves{};
  std::optional<query::Formula> hold_out;  ///< of swept parameters: records that are predicted, not fitted
  FitLoss loss = FitLoss::none;
  double width = 1.0;                 ///< of the loss, in weighted residuals
  std::size_t starts = 1;             ///< the first is the given one, the others are random within the bounds
  std::optional<std::size_t> follow;  ///< how many of them go on after the first steps; a quarter if absent
  std::uint64_t seed = 1;
  std::size_t iterations = 200;  ///< of one start, at most
  double tolerance = 1e-8;       ///< change of an unknown at which a search ends, see refine()
  StandardErrors standard_errors = StandardErrors::automatic;
  std::string records = "record";  ///< what pictures call the records: measured, simulated
  std::optional<GlobalSearch> global;
  yaml::Place place;
};

/// Reads one entry of `fit.curves` for a section with these parameters; nothing where it is wrong, which goes
/// to `faults`.
std::optional<FitCurve> read_fit_curve(const yaml::Node& node, const query::SymbolTable& names,
                                       const std::vector<FitParameter>& parameters, yaml::Faults& faults);

/// The keys of the section `fit`.
const yaml::Key& fit_form();

/// Reads the value under the key `fit`. Everything that is wrong goes to `faults`; what is returned then is
/// of no use.
FitRequest read_fit(const yaml::Node& node, const query::SymbolTable& names, const diagram::Diagram& diagram,
                    yaml::Faults& faults);

}  // namespace stepwire::estimation
