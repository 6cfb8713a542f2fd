// Fields of the result of a fit.
#include <cmath>

#include "engine/analyse/estimation/fit.hpp"
#include "engine/base/result/record.hpp"

namespace stepwire::estimation {

using result::Record;

static void declare(Record<FittedNumber>& is) {
  is.named("FittedParameter", "A number that a fit found, in SI.");
  is.field("name", &FittedNumber::name, "name of the parameter");
  is.omitted(
      "record", [](const FittedNumber& of) { return result::text_if_any(of.record); },
      "record with this value; missing if all records share it");
  is.field("value", &FittedNumber::value, "value", "SI");
  is.field("unit", &FittedNumber::dimension, "SI unit; null if unknown");
  is.field("start", &FittedNumber::start, "value at the start", "SI");
  is.field("standard_error", &FittedNumber::standard_error, "error of the interval; null if undetermined",
           "SI");
  is.field("standard_error_classical", &FittedNumber::classical_error, "error for independent rows", "SI");
  is.field("standard_error_serial", &FittedNumber::serial_error, "error for correlated rows of a time series",
           "SI");
  is.field(
      "interval",
      [](const FittedNumber& of) {
        return std::array{of.low, of.high};
      },
      "95 % interval", "SI");
  is.field("at_bound", &FittedNumber::at_bound, "true at a bound of the file");
}

static void declare(Record<FittedRecord>& is) {
  is.named("FittedRecord", "Agreement of the model with a record.");
  is.field("record", &FittedRecord::label, "label of the record");
  is.field("held_out", &FittedRecord::held_out, "true if the fit does not use it");
  is.field("rows", &FittedRecord::rows, "number of compared rows");
  is.field(
      "fit",
      [](const FittedRecord& of) {
        std::vector<double> all;
        for (const ComparedRows& rows : of.comparisons) all.push_back(rows.agreement);
        return all;
      },
      "agreement of each comparison; null for a constant record", "%");
}

static void declare(Record<FittedCurve>& is) {
  is.named("FittedCurve", "A function of the fitted parameters with its 95 % interval, in SI.");
  is.field("curve", &FittedCurve::name, "label of the function");
  is.field("unit", &FittedCurve::dimension, "SI unit of the function; null if unknown");
  is.field("at", &FittedCurve::at, "values of the variable", "SI");
  is.field("value", &FittedCurve::value, "values of the function", "SI");
  is.field("low", &FittedCurve::low, "lower ends of the interval", "SI");
  is.field("high", &FittedCurve::high, "upper ends of the interval", "SI");
  is.field("data_range", &FittedCurve::data_range, "range of the variable in the records; empty if unknown",
           "SI");
}

static void declare(Record<FittedStart>& is) {
  is.named("FittedStart", "Result of the search from one start.");
  is.field("cost", &FittedStart::cost, "final cost; null if nothing could be evaluated");
  is.field("finished", &FittedStart::finished, "false if others were ahead and it was given up");
  is.field("iterations", &FittedStart::iterations, "number of iterations");
}

void declare(Record<FitResult>& is) {
  is.named("FitResult", "The result of a fit: fit.json.");
  is.field("file", &FitResult::file, "diagram file");
  is.field("parameters", &FitResult::numbers, "fitted numbers");
  is.field("correlation", &FitResult::correlation, "correlation of the fitted numbers");
  is.field("cost", &FitResult::cost, "half of the sum of squares of the residuals after the loss");
  is.field("deviation", &FitResult::deviation, "standard deviation of a weighted residual");
  is.field("degrees_of_freedom", &FitResult::freedom, "rows minus fitted numbers");
  is.field(
        "standard_errors",
        [](const FitResult& of) {
          return of.standard_errors == StandardErrors::serial ? "serial" : "classical";
        },
        "kind of the standard errors of the intervals")
      .choices = {"serial", "classical"};
  is.field("rows_in_time", &FitResult::in_time, "true if the rows are a time series");
  is.field(
      "residuals_together", [](const FitResult& of) { return static_cast<std::size_t>(of.together); },
      "number of consecutive rows over which residuals are correlated");
  is.field("records", &FitResult::records, "agreement with each record");
  is.field("curves", &FitResult::curves, "functions of the fitted parameters");
  is.field("starts", &FitResult::starts, "searches");
  is.field("findings", &FitResult::findings, "undetermined parameters, bounds, refused values");
  is.field("converged", &FitResult::converged, "true at a minimum");
  is.field("limited", &FitResult::limited, "true if the diagram refuses values of a lower cost");
  is.field("interrupted", &FitResult::interrupted, "true if it was interrupted");
  is.field("compiled", &FitResult::compiled, "true if one compilation served all runs");
  is.field("in_part", &FitResult::in_part, "true if only the blocks that the parameters affect ran");
  is.field("duration", &FitResult::seconds, "duration of the fit", "s");
}

}  // namespace stepwire::estimation
