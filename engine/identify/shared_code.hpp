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

/// Plans one record with values of the parameters. Throws Error where the diagram refuses them.
using Planner = std::function<Plan(std::size_t record, const Values& values)>;

/// Makes code for all records with one compilation; nothing where no compiler is there or where the numbers
/// of the plans are no affine functions of the parameters at some point that is tried.
std::vector<RecordCode> share_code(const std::vector<Plan>& at_start,
                                   const std::vector<FitParameter>& parameters, const Planner& plan,
                                   CodeSource& source);

}  // namespace stepwire
