#include "engine/analyse/tuning/target_search.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace stepwire::tuning {

namespace {

constexpr double step = 0.1;  // of the way between the bounds, on each side

/// What the targets are off as Ceres asks for it. An exception ends the search, and is kept.
class Offs : public ceres::CostFunction, public ceres::IterationCallback {
 public:
  Offs(const LookAt& look, const TuneRequest& request) : look_(look), request_(request) {
    set_num_residuals(static_cast<int>(request.targets.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(request.parameters.size()));
  }

  bool Evaluate(const double* const* at, double* residuals, double** jacobians) const override {
    if (thrown) return false;
    try {
      return evaluate(Shares(at[0], at[0] + request_.parameters.size()), residuals,
                      jacobians ? jacobians[0] : nullptr);
    } catch (...) {
      thrown = std::current_exception();
      return false;
    }
  }

  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return thrown ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

  mutable std::exception_ptr thrown{};

 private:
  bool evaluate(const Shares& at, double* residuals, double* jacobian) const {
    const Evaluation& one = look_(at);
    if (one.is_bad()) return false;
    std::ranges::copy(one.offs, residuals);
    if (!jacobian) return true;
    std::size_t without = 0;
    const auto rows = target_jacobian(look_, request_, at, without);
    if (!rows) return false;
    for (const std::vector<double>& row : *rows) jacobian = std::ranges::copy(row, jacobian).out;
    return true;
  }

  const LookAt& look_;
  const TuneRequest& request_;
};

}  // namespace

std::optional<std::vector<std::vector<double>>> target_jacobian(const LookAt& look,
                                                                const TuneRequest& request, const Shares& at,
                                                                std::size_t& without) {
  std::vector<std::vector<double>> rows(request.targets.size());
  for (without = 0; without < at.size(); ++without) {
    Shares low = at, high = at;
    low[without] = std::max(0.0, at[without] - step);
    high[without] = std::min(1.0, at[without] + step);
    const Evaluation below = look(low), above = look(high);  // a look may move what another one gave
    if (below.is_bad() || above.is_bad()) return std::nullopt;
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i].push_back((above.offs[i] - below.offs[i]) / (high[without] - low[without]));
  }
  return rows;
}

bool search_targets(const LookAt& look, const TuneRequest& request, const Shares& from) {
  Offs offs(look, request);
  Shares shares = from;
  ceres::Problem::Options owned;
  owned.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(owned);
  problem.AddResidualBlock(&offs, nullptr, shares.data());
  for (int i = 0; i < static_cast<int>(shares.size()); ++i) {
    problem.SetParameterLowerBound(shares.data(), i, 0.0);
    problem.SetParameterUpperBound(shares.data(), i, 1.0);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.parameter_tolerance = request.tolerance;
  options.function_tolerance = request.tolerance;
  options.max_num_iterations = static_cast<int>(std::min<std::size_t>(request.evaluations, 1'000'000));
  options.callbacks.push_back(&offs);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (offs.thrown) std::rethrow_exception(offs.thrown);
  return summary.termination_type == ceres::CONVERGENCE;
}

}  // namespace stepwire::tuning
