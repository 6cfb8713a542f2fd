#include "engine/simulate/run/step_probe.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "engine/base/math/elementary.hpp"

namespace stepwire::run {

namespace {

using Complex = std::complex<double>;
constexpr double smallest_size = 1e-9;  // of a state, in its SI unit
constexpr Eigen::Index most_states = 400;
constexpr Eigen::Index most_for_slow_growth = 64;  // states, since eigenvalues take their third power

/// Returns the modulus of the stability function R(z) of a method: the factor of x per step h in x' = lambda
/// x, with z = h lambda. Hairer and Wanner, Solving Ordinary Differential Equations II, IV.2.
double stability(const solve::Tableau& tableau, Complex z) {
  std::vector<Complex> slopes = {1.0};
  const auto sum = [&](const std::vector<double>& weights) {
    Complex total = 0.0;
    for (std::size_t j = 0; j < weights.size(); ++j) total += weights[j] * slopes[j];
    return total;
  };
  for (const std::vector<double>& row : tableau.a) slopes.push_back(1.0 + z * sum(row));
  return std::abs(1.0 + z * sum(tableau.b));
}

/// Returns the factor per step that makes 2 in all steps of a run.
double growth_in_all(const plan::Plan& plan) {
  if (plan.layout.state_count > most_for_slow_growth) return 1.1;
  const auto steps = static_cast<double>(std::max<std::int64_t>(plan.steps, 1));
  return std::clamp(fn::pow(2.0, 1.0 / steps), 1.0 + 1e-9, 1.1);
}

/// Returns a modulus of z in the left half plane below which the method amplifies nothing by `growth`.
double rate_of_growth(const solve::Tableau& tableau, double growth) {
  double modulus = 8.0;
  const auto grows = [&](double angle) {
    return stability(tableau, Complex{modulus * fn::cos(angle), modulus * fn::sin(angle)}) > growth;
  };
  for (; modulus > 1e-9; modulus *= 0.5) {
    bool any = false;
    for (int k = 0; k <= 12 && !any; ++k) any = grows(std::numbers::pi * (0.5 + k / 24.0));
    if (!any) break;
  }
  return modulus;
}

/// Mode with the largest growth by the method, among the modes that the equations damp.
struct Mode {
  double growth = 1.0;         ///< factor per step
  Complex rate = 0.0;          ///< eigenvalue [1/s]
  Eigen::Index state = 0;      ///< State of which it is the largest part.
  Eigen::RowVectorXcd left{};  ///< Left eigenvector: its product with the derivatives is the mode's part.
  Complex part = 0.0;          ///< of the mode in the derivatives
};

class StepProbe {
 public:
  StepProbe(BoundBlocks& blocks, Stepper& stepper, StepProbeMemory& memory)
      : plan_(blocks.plan()),
        values_(blocks.values()),
        stepper_(stepper),
        tableau_(*memory.tableau),
        memory_(memory),
        states_(values_ + plan_.layout.states, static_cast<Eigen::Index>(plan_.layout.state_count)),
        start_(memory.start),
        time_(values_[plan::Layout::time]) {
    std::copy_n(values_, plan_.layout.size, memory.kept.begin());
    memory.start = states_;
  }

  void look() {
    const auto mode = find_mode();
    std::ranges::copy(memory_.kept, values_);
    if (mode) write(*mode);
  }

 private:
  std::optional<Mode> find_mode() {
    if (!changes() || !errs()) return std::nullopt;
    Mode mode = worst_mode();
    if (mode.left.size() > 0 && grows(mode)) return mode;
    return std::nullopt;
  }

  void find_slopes(double time) {
    values_[plan::Layout::time] = time;
    stepper_.follow_time();
    stepper_.find_outputs();
    stepper_.find_slopes();
  }
  void step(double time, double length) {
    find_slopes(time);
    stepper_.advance({time, time + length, length});
  }

  /// True if the derivative of a state changes it within a step as that of an unstable mode of a tenth of it.
  bool changes() {
    find_slopes(time_);
    const Eigen::Map<const Eigen::ArrayXd> slopes(values_ + plan_.layout.derivatives, states_.size());
    return !((plan_.diagram.step * slopes.abs() <= 0.1 * memory_.least_rate * sizes()).all());
  }

  /// True if one step and two half steps differ as for an unstable mode of a tenth of a state.
  bool errs() {
    const double most = 0.05 * (memory_.least_growth - 1.0);
    const double h = plan_.diagram.step;
    step(time_, h);
    Eigen::VectorXd& whole = memory_.whole;
    whole = states_;
    states_ = start_;
    step(time_, 0.5 * h);
    step(time_ + 0.5 * h, 0.5 * h);
    for (Eigen::Index i = 0; i < whole.size(); ++i) {
      const double size = std::max({std::abs(whole[i]), std::abs(start_[i]), smallest_size});
      if (!(std::abs(states_[i] - whole[i]) <= most * size)) return true;
    }
    return false;
  }

  Eigen::ArrayXd sizes() const { return start_.cwiseAbs().array().max(smallest_size); }

  /// Returns the Jacobian at the present states, and stores their derivatives in `base`.
  Eigen::MatrixXd jacobian(Eigen::VectorXd& base) {
    const Eigen::Map<Eigen::VectorXd> slopes(values_ + plan_.layout.derivatives, states_.size());
    Eigen::MatrixXd A(states_.size(), states_.size());
    states_ = start_;
    find_slopes(time_);
    base = slopes;
    for (Eigen::Index i = 0; i < states_.size(); ++i) {
      const double change = plan_.diagram.step * base[i];
      states_[i] = start_[i] + 1e-7 * std::max({std::abs(start_[i]), std::abs(change), 1e-3});
      find_slopes(time_);
      A.col(i) = (slopes - base) / (states_[i] - start_[i]);
      states_[i] = start_[i];
    }
    return A;
  }

  /// Returns the mode that the method amplifies most, among those that are a tenth of a state or more. The
  /// part of a mode in the states is its part in their derivatives, divided by the eigenvalue.
  Mode worst_mode() {
    Mode worst{.growth = memory_.least_growth};
    Eigen::VectorXd slopes;
    const Eigen::MatrixXd A = jacobian(slopes);
    if (!A.allFinite() || !slopes.allFinite()) return worst;
    const Eigen::EigenSolver<Eigen::MatrixXd> modes(A);
    const Eigen::MatrixXcd shapes = modes.eigenvectors();
    const Eigen::MatrixXcd left = shapes.inverse();
    const Eigen::VectorXcd parts = left * slopes.cast<Complex>();
    const Eigen::ArrayXd size = sizes();
    for (Eigen::Index k = 0; k < parts.size(); ++k) {
      const Complex rate = modes.eigenvalues()[k];
      const double growth = stability(tableau_, plan_.diagram.step * rate);
      if (rate.real() > 1e-6 * std::abs(rate) || !(growth > worst.growth)) continue;
      Eigen::Index state = 0;
      const double part = ((shapes.col(k) * (parts[k] / rate)).cwiseAbs().array() / size).maxCoeff(&state);
      if (!(part < 0.1)) worst = {growth, rate, state, left.row(k), parts[k]};
    }
    return worst;
  }

  /// True if further steps amplify the mode within the time in which it grows twentyfold. A jump or a bend of
  /// the equations, as of dry friction, keeps a part small whose linearization grows.
  bool grows(const Mode& mode) {
    states_ = start_;
    const double h = plan_.diagram.step;
    const double steps = std::clamp(std::ceil(fn::log(20.0) / fn::log(mode.growth)), 1.0, 2000.0);
    for (double k = 0.0; k < steps; ++k) step(time_ + k * h, h);
    find_slopes(time_ + steps * h);
    const Eigen::Map<const Eigen::VectorXd> slopes(values_ + plan_.layout.derivatives, states_.size());
    const Complex part = mode.left * slopes.cast<Complex>();
    return !(std::abs(part) <= fn::pow(mode.growth, 0.5 * steps) * std::abs(mode.part));
  }

  /// Returns the longest step [s] at which the method does not amplify a mode; 0 if there is no such step.
  double longest_step(Complex rate) const {
    double low = plan_.diagram.step, high = low;
    for (int k = 0; stability(tableau_, low * rate) > 1.0; ++k) {
      if (k == 10) return 0.0;
      high = low;
      low *= 0.5;
    }
    for (int k = 0; k < 30; ++k) {
      const double middle = 0.5 * (low + high);
      (stability(tableau_, middle * rate) > 1.0 ? high : low) = middle;
    }
    return low;
  }

  void write(const Mode& mode) {
    double* const report = values_ + plan_.layout.report;
    solve::StepReport{report}.write(solve::StepReport::unstable, mode.growth, mode.state);
    report[solve::StepReport::longest_step] = longest_step(mode.rate);
  }

  const plan::Plan& plan_;
  double* const values_;
  Stepper& stepper_;
  const solve::Tableau& tableau_;
  StepProbeMemory& memory_;
  Eigen::Map<Eigen::VectorXd> states_;
  const Eigen::VectorXd& start_;
  const double time_;
};

}  // namespace

void StepProbeMemory::prepare(const plan::Plan& plan) {
  if (ready) return;
  ready = true;
  const auto states = static_cast<Eigen::Index>(plan.layout.state_count);
  if (plan.diagram.error_control || states == 0 || states > most_states) return;
  tableau = solve::find_tableau(plan.diagram.solver);
  if (!tableau) return;
  least_growth = growth_in_all(plan);
  least_rate = rate_of_growth(*tableau, least_growth);
  kept.resize(plan.layout.size);
  start.resize(states);
  whole.resize(states);
}

std::int64_t next_step_check(const plan::Plan& plan, std::int64_t tick) {
  const bool hides = !plan.guards.empty() || plan.updates_continuous;
  std::int64_t next = std::numeric_limits<std::int64_t>::max();
  if (const std::int64_t part = plan.steps / (hides ? 8 : 4); part >= 4) next = (tick / part + 1) * part;
  if (hides)
    next = std::min(next, static_cast<std::int64_t>(std::bit_ceil(
                              static_cast<std::uint64_t>(std::max<std::int64_t>(tick + 1, 4)))));
  return next;
}

void find_unstable_steps(BoundBlocks& blocks, Stepper& stepper, StepProbeMemory& memory) {
  memory.prepare(blocks.plan());
  if (memory.tableau) StepProbe(blocks, stepper, memory).look();
}

}  // namespace stepwire::run
