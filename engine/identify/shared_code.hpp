#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/identify/affine_numbers.hpp"
#include "engine/identify/fit_request.hpp"
#include "engine/plan/compiled_plan.hpp"

namespace stepwire {

/// Code and start of a run of one record, for any values of the parameters.
class RecordCode {
 public:
  RecordCode(StepFunctions functions, AffineNumbers parameters, AffineNumbers workspace)
      : functions_(functions), parameters_(std::move(parameters)), workspace_(std::move(workspace)) {}

  CompiledPlan code(const Values& values) const { return {functions_, parameters_.at(values)}; }
  std::vector<double> workspace(const Values& values) const { return workspace_.at(values); }
  bool agrees(const Values& values, const CompiledPlan& code, const std::vector<double>& workspace) const;

 private:
  StepFunctions functions_;
  AffineNumbers parameters_, workspace_;
};

/// Code for plans of any numbers, as long as they differ in nothing but what differed among those that were
/// compiled.
class PlannedCode {
 public:
  explicit PlannedCode(const std::vector<CompiledPlan>& compiled);

  /// With the numbers of a plan; nothing where it differs in more.
  std::optional<CompiledPlan> with(std::vector<double> numbers) const;

 private:
  StepFunctions functions_;
  std::vector<double> numbers_;
  std::vector<char> varies_;
};

/// What one compilation gives for all records.
struct SharedCode {
  std::vector<RecordCode> records;  ///< one for each record, where the numbers of plans are affine functions
  std::optional<PlannedCode>
      planned;  ///< where they are not, so that each run needs a plan, but no compilation
};

/// Plans one record with values of the parameters. Throws Error where the diagram refuses them.
using Planner = std::function<Plan(std::size_t record, const Values& values)>;

/// Makes code for all records with one compilation; neither of both where no compiler is there or the plans
/// differ in more than numbers.
SharedCode share_code(const std::vector<Plan>& at_start, const std::vector<FitParameter>& parameters,
                      const Planner& plan, CodeSource& source);

}  // namespace stepwire
