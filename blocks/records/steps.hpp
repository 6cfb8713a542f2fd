#pragma once

#include "blocks/records/record.hpp"
#include "blocks/records/step_options.hpp"

namespace stepwire {

// The steps of a preparation, each in the file of its name; preparation.cpp lists them with their keys. Each
// works on all columns of the record alike.

/// Evenly spaced rows from the first one on, `resample` apart, the last one at or before the old last one.
/// Between the old rows run straight lines, or, for evenly spaced ones, a signal without content above half
/// of their rate. To fewer rows, faster content folds: low_pass first.
void resample(Record& record, const StepOptions& given);

/// Takes a constant from each column: its mean, its first row, or a given value.
void remove_offset(Record& record, const StepOptions& given);

/// Keeps the rows from the first to the last movement of a column of the file: from where it leaves its first
/// value, to where it reaches its last one, by more than `threshold` of its range. That column is taken as
/// the file has it, so that all columns of a file are cut alike, whatever is done to them before.
void trim(Record& record, const StepOptions& given);

/// Butterworth filter, run forward and backward: zero phase, gain 1 / (1 + (tan(pi f T)/tan(pi fc T))^(2
/// order)), that is 1/2 (-6 dB) at fc, as filtfilt of scipy and MATLAB has it, with their ends.
void low_pass(Record& record, const StepOptions& given);

/// Derivative by central differences, one-sided ones of second order at the ends: y' = (y+ - y-) / 2h,
/// y'' = (y+ - 2y + y-) / h^2. Its unit is per second, or per second squared.
void differentiate(Record& record, const StepOptions& given);

}  // namespace stepwire
