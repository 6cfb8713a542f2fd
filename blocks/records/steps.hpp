#pragma once

#include "blocks/records/record.hpp"
#include "blocks/records/step_options.hpp"

namespace stepwire {

// Steps of a preparation, each in the file of its name; preparation.cpp lists them with their keys. Each
// applies to all columns of the record.

/// Resamples to evenly spaced rows, `resample` apart, from the first one to at most the last one. In between,
/// the interpolation is linear or, for evenly spaced rows, by a signal without content above half of their
/// rate. Downsampling aliases faster content, so low_pass should precede it.
void resample(Record& record, const StepOptions& given);

/// Subtracts a constant from each column: its mean, its first row, or a given value.
void remove_offset(Record& record, const StepOptions& given);

/// Keeps the rows from the first to the last movement of a column of the file. The movement begins where the
/// column leaves its first value by more than `threshold` of its range, and ends where it reaches its last
/// one. The column is read from the file, so that all columns of a file are cut alike, regardless of previous
/// steps.
void trim(Record& record, const StepOptions& given);

/// Applies a Butterworth filter forward and backward, like filtfilt of scipy and MATLAB, with their ends. It
/// has zero phase and the gain 1 / (1 + (tan(pi f T)/tan(pi fc T))^(2 order)), which is 1/2 (-6 dB) at fc.
void low_pass(Record& record, const StepOptions& given);

/// Differentiates by central differences, with one-sided ones of second order at the ends: y' = (y+ - y-) /
/// 2h, y'' = (y+ - 2y + y-) / h^2. The unit is per second, or per second squared.
void differentiate(Record& record, const StepOptions& given);

}  // namespace stepwire
