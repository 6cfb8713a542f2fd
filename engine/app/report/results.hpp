#pragma once

#include <string>
#include <vector>

#include "engine/base/result/result_type.hpp"

namespace stepwire::report {

/// Result of a kind of job.
struct JobResult {
  std::string job;  ///< "fit"
  const result::RecordType& type;
};

/// Returns the results of all kinds of jobs. A job is here once; pages, Python and stubs follow.
const std::vector<JobResult>& job_results();

/// Returns the fields of all results as JSON, from which Python makes classes.
json::Json results_description();
/// Returns the Python stub of all results: records.pyi of the package.
std::string results_stub();
/// Returns the types of all results as a module of TypeScript.
std::string results_typescript();

}  // namespace stepwire::report
