#include "engine/analyse/estimation/bounded_squares.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <exception>

namespace stepwire::estimation {

namespace {

/// Adapter of a problem to Ceres.
class Asked : public ceres::CostFunction, public ceres::IterationCallback {
 public:
  Asked(const BoundedSquares& problem, std::size_t size) : problem_(problem), size_(size) {
    set_num_residuals(static_cast<int>(problem.residuals));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(size));
  }

  bool Evaluate(const double* const* at, double* residuals, double** jacobians) const override {
    if (thrown) return false;
    try {
      return problem_.evaluate({at[0], at[0] + size_}, residuals, jacobians ? jacobians[0] : nullptr);
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
  const BoundedSquares& problem_;
  const std::size_t size_;
};

ceres::Solver::Options options_of(const BoundedSquares& problem) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.initial_trust_region_radius = 1.0;                  // a smaller first step, since scatter misleads
  options.line_search_interpolation_type = ceres::QUADRATIC;  // no derivatives along a line
  options.parameter_tolerance = options.function_tolerance = problem.tolerance;
  options.max_num_iterations = static_cast<int>(std::min<std::size_t>(problem.iterations, 1'000'000));
  return options;
}

/// Suppresses Ceres' log of points that cannot be evaluated; the result reports these.
void keep_log_inside() {
  FLAGS_minloglevel = google::GLOG_FATAL;
}

}  // namespace

bool minimise_squares(const BoundedSquares& problem, const std::vector<double>& from) {
  keep_log_inside();
  Asked asked(problem, from.size());
  std::vector<double> shares = from;
  ceres::Problem::Options owned;
  owned.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem squares(owned);
  squares.AddResidualBlock(&asked, nullptr, shares.data());
  for (int i = 0; i < static_cast<int>(shares.size()); ++i) {
    squares.SetParameterLowerBound(shares.data(), i, 0.0);
    squares.SetParameterUpperBound(shares.data(), i, 1.0);
  }
  ceres::Solver::Options options = options_of(problem);
  options.callbacks.push_back(&asked);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &squares, &summary);
  if (asked.thrown) std::rethrow_exception(asked.thrown);
  return summary.termination_type == ceres::CONVERGENCE;
}

}  // namespace stepwire::estimation
