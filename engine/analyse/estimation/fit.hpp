#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/estimation/fitted_curve.hpp"
#include "engine/analyse/estimation/model_runs.hpp"
#include "engine/analyse/estimation/residuals.hpp"
#include "engine/base/messages/items.hpp"

namespace stepwire::estimation {

/// What a call may change about a fit.
struct FitOptions {
  unsigned threads = 0;  ///< 0: all cores; the result is the same to the last bit
  std::function<void(double fraction, const std::string& what)> progress{};
  messages::ItemWorkers* workers = nullptr;  ///< that search from the starts; null: this process does
};

/// A number that was found, in SI.
struct FittedNumber {
  std::string name;    ///< of the parameter
  std::string record;  ///< whose own it is; empty where all records share it
  double value = 0.0, start = 0.0;
  double standard_error = 0.0;   ///< that of the interval; nan where it is not known.
  double classical_error = 0.0;  ///< Error of independent rows.
  double serial_error = 0.0;     ///< Of a time series whose residuals go together; nan of others.
  double low = 0.0, high = 0.0;  ///< of the 95 % interval
  bool at_bound = false;
  std::optional<unit::Dimension> dimension{};
  std::string unit{};  ///< for showing it; empty: SI

  /// The parameter and whose it is: "bias of 10mm2Hz_0A".
  std::string title() const;
};

/// How well a record is described.
struct FittedRecord {
  std::string label;
  bool held_out = false;
  std::size_t rows = 0;
  std::vector<ComparedRows> comparisons{};  ///< none where it could not be predicted
};

/// How a search from one start went.
struct FittedStart {
  double cost = 0.0;      ///< where it ended; infinite where nothing could be evaluated
  bool finished = false;  ///< false: given up early, since others were ahead
  std::size_t iterations = 0;
};

struct FitResult {
  std::vector<FittedNumber> numbers;
  Eigen::MatrixXd correlation;  ///< of the numbers
  std::vector<FittedRecord> records;
  std::vector<FittedCurve> curves;
  std::vector<FittedStart> starts;
  std::vector<std::string> findings;  ///< what cannot be known, is at a bound or is refused
  double cost = 0.0;                  ///< half of the sum of what the weighted residuals count
  double deviation = 0.0;             ///< of a weighted residual
  double freedom = 0.0;               ///< rows less numbers found
  Eigen::Index together = 0;          ///< rows over which residuals go together, one behind the other
  bool in_time = false;               ///< the rows are a time series
  StandardErrors standard_errors = StandardErrors::classical;  ///< those of the intervals
  bool converged = false, interrupted = false;
  bool limited = false;   ///< the diagram refuses what the records want
  bool compiled = false;  ///< one compilation served all runs
  bool in_part = false;   ///< only what the parameters move was run, the rest played back
  bool refused = false;   ///< the diagram does not take what was found
  double seconds = 0.0;

  std::vector<diagram::Setting> shared;                   ///< what sets the parameters that all records share
  std::vector<std::vector<diagram::Setting>> of_records;  ///< beside them, what sets each record's own
};

/// Finds the parameters that a file asks for. Throws Error for what is wrong with the request, the records or
/// the start. What was interrupted before the first run was done has no records.
FitResult fit(const ModelSource& source, const run::Job& job, const FitRequest& request,
              const FitOptions& options = {});

}  // namespace stepwire::estimation
