#pragma once

#include <span>
#include <string>

#include "engine/analyse/comparison/compare.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/base/junit/junit.hpp"

namespace stepwire::report {

/// Returns the claims of a run as test cases. A failure that the file expects is skipped. A run that ended
/// early has an error beside them.
junit::TestSuite suite_of(const session::LoadedModel& model, const session::Outcome& outcome);

/// Returns claims and faults of a run of a file as test cases.
junit::TestSuite suite_of(const std::string& name, double seconds, std::span<const claim::Verdict> verdicts,
                          const run::RunResult& result);

/// Returns the suite of a file that cannot be run.
junit::TestSuite suite_of_fault(const std::string& file, const std::string& fault);

/// Returns the signals of a comparison as test cases.
junit::TestSuite suite_of(const comparison::RecordingDifference& difference);

/// Writes suites to a file. Throws EnvironmentError.
void write_junit(const std::string& file, const std::vector<junit::TestSuite>& suites);

}  // namespace stepwire::report
