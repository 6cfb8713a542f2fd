#include "engine/app/report/results.hpp"

#include "engine/analyse/comparison/compare.hpp"
#include "engine/analyse/coverage/coverage.hpp"
#include "engine/analyse/estimation/fit.hpp"
#include "engine/analyse/linear/analysis.hpp"
#include "engine/analyse/linear/trim.hpp"
#include "engine/analyse/tuning/tune.hpp"
#include "engine/app/difference/difference.hpp"
#include "engine/app/report/profile_report.hpp"
#include "engine/app/session/loop_run.hpp"
#include "engine/app/session/mutating.hpp"
#include "engine/app/session/result_comparison.hpp"
#include "engine/app/session/run_result.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/app/simulink/import_result.hpp"

namespace stepwire::report {

namespace {

std::vector<const result::RecordType*> types() {
  std::vector<const result::RecordType*> types;
  for (const JobResult& one : job_results()) types.push_back(&one.type);
  return types;
}

const std::string stub_head = R"py("""Records of results, printed by 'stepwire format --python'."""

from typing import Any, ClassVar, Mapping, Optional, TypeVar

_R = TypeVar("_R", bound="Record")

class Record:
    """Named values of a result. A missing number is nan, a missing text empty."""
    field_units: ClassVar[dict[str, str]]
    """the unit of each field that has one"""
    field_docs: ClassVar[dict[str, str]]
    """the meaning of each field"""
    @classmethod
    def read(cls: type[_R], data: Mapping[str, Any]) -> _R:
        """The record of an object of the JSON file."""
    def to_dict(self) -> dict[str, Any]:
        """The fields by name, those of inner records, too."""
)py";

}  // namespace

const std::vector<JobResult>& job_results() {
  static const std::vector<JobResult> all{{"run", result::record_type<session::RunReport>()},
                                          {"loop", result::record_type<session::LoopOutcome>()},
                                          {"study", result::record_type<session::StudyReport>()},
                                          {"claims", result::record_type<session::JudgedClaim>()},
                                          {"profile", result::record_type<ProfileReport>()},
                                          {"fit", result::record_type<estimation::FitResult>()},
                                          {"tune", result::record_type<tuning::TuneResult>()},
                                          {"linearize", result::record_type<linear::Analysis>()},
                                          {"trim", result::record_type<linear::TrimResult>()},
                                          {"coverage", result::record_type<coverage::Coverage>()},
                                          {"mutate", result::record_type<session::MutationResult>()},
                                          {"import", result::record_type<simulink::ImportResult>()},
                                          {"compare", result::record_type<comparison::RecordingDifference>()},
                                          {"diff", result::record_type<difference::Difference>()},
                                          {"diff_results", result::record_type<session::ResultComparison>()}};
  return all;
}

json::Json results_description() {
  return result::description_of(types());
}

std::string results_stub() {
  return stub_head + result::python_stub_of(types());
}

std::string results_typescript() {
  return "// Results of jobs, printed by 'stepwire format --typescript'. A number that is not finite is "
         "null.\n" +
         result::typescript_of(types());
}

}  // namespace stepwire::report
