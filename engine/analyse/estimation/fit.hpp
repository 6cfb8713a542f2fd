#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/estimation/model_runs.hpp"
#include "engine/analyse/estimation/residuals.hpp"
#include "engine/base/messages/items.hpp"
#include "engine/base/result/record.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::estimation {

/// A function of the fitted parameters with its 95 % interval, in SI.
struct FittedCurve {
  std::string name;     ///< Label of the function.
  std::string unit{};   ///< Unit of its drawing; empty if unknown.
  std::string label{};  ///< Label of the variable's axis.
  std::optional<unit::Dimension> dimension{};
  std::vector<double> at{}, value{}, low{}, high{};
  /// Range of the variable in the records. Empty if the file has no expression of it, or nothing is recorded.
  std::vector<double> data_range{};
};

/// Options of a call that are not part of the file.
struct FitOptions {
  unsigned threads = 0;  ///< 0: all cores. The result is the same to the last bit.
  std::function<void(double fraction, const std::string& what)> progress{};
  messages::ItemWorkers* workers =
      nullptr;  ///< Processes that search from the starts; nullptr: this process does.
};

/// A fitted number, in SI.
struct FittedNumber {
  std::string name;    ///< Name of the parameter.
  std::string record;  ///< Record with this value; empty if shared by all records.
  double value = 0.0, start = 0.0;
  double standard_error = 0.0;   ///< Error used for the interval; nan if undetermined.
  double classical_error = 0.0;  ///< Error of independent rows.
  double serial_error = 0.0;     ///< Error of a time series with correlated residuals; else nan.
  double low = 0.0, high = 0.0;  ///< 95 % interval.
  bool at_bound = false;
  std::optional<unit::Dimension> dimension{};
  std::string unit{};  ///< Unit in which it is shown; empty: SI.

  /// Returns the parameter and its record: "bias of 10mm2Hz_0A".
  std::string title() const;
};

/// Agreement of the model with a record.
struct FittedRecord {
  std::string label;
  bool held_out = false;
  std::size_t rows = 0;
  std::vector<ComparedRows> comparisons{};  ///< Empty if it could not be predicted.
};

/// Result of the search from one start.
struct FittedStart {
  double cost = 0.0;      ///< Final cost; infinite if nothing could be evaluated.
  bool finished = false;  ///< False: given up early, since others were ahead.
  std::size_t iterations = 0;
};

struct FitResult {
  std::string file{};  ///< Diagram file.
  std::vector<FittedNumber> numbers;
  Eigen::MatrixXd correlation;  ///< Correlation of the numbers.
  std::vector<FittedRecord> records;
  std::vector<FittedCurve> curves;
  std::vector<FittedStart> starts;
  std::vector<std::string> findings;  ///< Messages on undetermined parameters, bounds, refused values.
  double cost = 0.0;                  ///< Half of the sum of squares of the residuals after the loss.
  double deviation = 0.0;             ///< Standard deviation of a weighted residual.
  double freedom = 0.0;               ///< Rows minus fitted numbers.
  Eigen::Index together = 0;          ///< Number of consecutive rows over which residuals are correlated.
  bool in_time = false;               ///< True: the rows are a time series.
  StandardErrors standard_errors = StandardErrors::classical;  ///< Kind used for the intervals.
  bool converged = false, interrupted = false;
  bool astray = false;    ///< True: the search has ended, but at no minimum. A finding has the parameters.
  bool limited = false;   ///< True: the cost would fall further, but the diagram refuses those values.
  bool compiled = false;  ///< True: one compilation served all runs.
  bool in_part = false;   ///< True: only the blocks that the parameters affect ran; the rest was replayed.
  bool refused = false;   ///< True: the diagram refuses the fitted values.
  double seconds = 0.0;

  std::vector<diagram::Setting> shared;  ///< Settings of the parameters that all records share.
  std::vector<std::vector<diagram::Setting>> of_records;  ///< Additional settings of each record.
};

/// Fits the parameters of a file to its records. Throws Error for faults of the request, the records or the
/// start. Without a finished run (interrupted) the result has no records.
FitResult fit(const ModelSource& source, const run::Job& job, const FitRequest& request,
              const FitOptions& options = {});

/// Declares the fields of fit.json.
void declare(result::Record<FitResult>& is);

/// Returns sentences on doubtful results. A standard error is more than a hundred times its value. A record
/// is described no better than by its mean. Residuals are correlated, but the standard errors assume
/// independent rows.
std::vector<std::string> doubts_of(const FitResult& result);

}  // namespace stepwire::estimation
