#include "engine/analyse/linear/trim.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/linear/slopes.hpp"
#include "engine/analyse/linear/working_point.hpp"
#include "engine/model/diagram/block_keys.hpp"

namespace stepwire::linear {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double close_enough = 1e-9;  // residual, as a share of 1 or of its number

/// An unknown: a column of the working point.
struct Unknown {
  std::size_t column = 0;
  double lower = -unbounded, upper = unbounded;
};

/// An equation: a row of the working point equals a number.
struct Equation {
  std::size_t row = 0;
  double wanted = 0.0;
  bool rate = false;  ///< For a sampled state: next value minus value.
};

/// Finds the free numbers of an operating point. Unknowns are the columns of the working point without a
/// fixed value. Equations are that steady states do not change and that outputs have their fixed values.
/// There can be fewer unknowns than equations, or more, so the squared residuals are minimised by the
/// Levenberg-Marquardt method. Steps are cut at the bounds. Each iteration costs a Jacobian by differences,
/// two responses per unknown, and a trial step.
class Search {
 public:
  Search(WorkingPoint& point, const TrimRequest& request, const plan::Plan& plan)
      : point_(point), plan_(plan) {
    for (std::size_t s = 0; s < point.states().size(); ++s) add_state(s, request);
    for (std::size_t i = 0; i < point.inputs().size(); ++i) add_input(i, request.inputs[i]);
    for (std::size_t o = 0; o < point.outputs().size(); ++o)
      if (request.outputs[o].fixed)
        equations_.push_back({point.states().size() + o, *request.outputs[o].fixed, false});
  }

  TrimResult solve() {
    TrimResult result;
    Eigen::VectorXd residual = residuals();
    double damping = 1e-3;
    for (; result.iterations < 200 && size_of(residual) > 0.01 * close_enough && damping < 1e12;
         ++result.iterations) {
      const Eigen::MatrixXd slopes = jacobian();
      if (!step(slopes, residual, damping)) damping *= 10.0;
    }
    result.largest = size_of(residual);
    result.converged = result.largest <= close_enough;
    for (std::size_t e = 0; e < equations_.size(); ++e)
      result.residuals.emplace_back(channel_of(equations_[e]), residual[static_cast<Eigen::Index>(e)]);
    return result;
  }

  bool is_free(std::size_t column) const {
    return std::ranges::find(unknowns_, column, &Unknown::column) != unknowns_.end();
  }
  bool at_bound(std::size_t column) const {
    const auto unknown = std::ranges::find(unknowns_, column, &Unknown::column);
    const double value = point_.value(column);
    return unknown != unknowns_.end() && (value <= unknown->lower || value >= unknown->upper);
  }

 private:
  void add_state(std::size_t s, const TrimRequest& request) {
    const std::string& name = point_.states()[s].channel.name;
    const auto entry =
        std::ranges::find(request.states, name, [](const TrimEntry& one) { return one.name.name; });
    const bool named = entry != request.states.end();
    if (!named || entry->steady) equations_.push_back({s, 0.0, true});
    if (named)
      add_unknown(s, *entry);
    else
      unknowns_.push_back({s});
  }

  void add_input(std::size_t i, const TrimEntry& entry) { add_unknown(point_.states().size() + i, entry); }

  void add_unknown(std::size_t column, const TrimEntry& entry) {
    if (entry.fixed) return point_.set(column, *entry.fixed);
    if (entry.start) point_.set(column, *entry.start);
    unknowns_.push_back({column, entry.lower.value_or(-unbounded), entry.upper.value_or(unbounded)});
    point_.set(column, std::clamp(point_.value(column), unknowns_.back().lower, unknowns_.back().upper));
  }

  Eigen::VectorXd residuals() { return of(point_.respond()); }

  Eigen::VectorXd of(const Eigen::VectorXd& response) const {
    Eigen::VectorXd residual(static_cast<Eigen::Index>(equations_.size()));
    for (std::size_t e = 0; e < equations_.size(); ++e) {
      const Equation& equation = equations_[e];
      const double own = equation.rate && point_.sampled() ? point_.value(equation.row) : equation.wanted;
      residual[static_cast<Eigen::Index>(e)] = response[static_cast<Eigen::Index>(equation.row)] - own;
    }
    return residual;
  }

  Eigen::MatrixXd jacobian() {
    Eigen::MatrixXd slopes(static_cast<Eigen::Index>(equations_.size()),
                           static_cast<Eigen::Index>(unknowns_.size()));
    for (std::size_t u = 0; u < unknowns_.size(); ++u) {
      const std::size_t column = unknowns_[u].column;
      const double here = point_.value(column);
      slopes.col(static_cast<Eigen::Index>(u)) = slopes_of(
                                                     [&](double value) {
                                                       point_.set(column, value);
                                                       Eigen::VectorXd residual = residuals();
                                                       point_.set(column, here);
                                                       return residual;
                                                     },
                                                     here, {std::exp2(-20), point_.most_change(column)})
                                                     .value;
    }
    return slopes;
  }

  /// Tries one Levenberg-Marquardt step; false, with the values restored, if the residuals do not fall.
  bool step(const Eigen::MatrixXd& slopes, Eigen::VectorXd& residual, double& damping) {
    if (!slopes.allFinite() || !residual.allFinite()) return false;
    const Eigen::VectorXd sizes = slopes.colwise().norm().transpose().cwiseMax(1e-12);
    const Eigen::MatrixXd scaled = slopes * sizes.cwiseInverse().asDiagonal();
    Eigen::MatrixXd normal = scaled.transpose() * scaled;
    normal.diagonal().array() += damping;
    const Eigen::VectorXd change =
        sizes.cwiseInverse().asDiagonal() * normal.ldlt().solve(scaled.transpose() * -residual);
    const Eigen::VectorXd before = values();
    for (std::size_t u = 0; u < unknowns_.size(); ++u)
      point_.set(unknowns_[u].column,
                 std::clamp(before[static_cast<Eigen::Index>(u)] + change[static_cast<Eigen::Index>(u)],
                            unknowns_[u].lower, unknowns_[u].upper));
    const Eigen::VectorXd after = residuals();
    if (after.allFinite() && after.squaredNorm() < residual.squaredNorm()) {
      residual = after;
      damping = std::max(1e-14, 0.1 * damping);
      return true;
    }
    for (std::size_t u = 0; u < unknowns_.size(); ++u)
      point_.set(unknowns_[u].column, before[static_cast<Eigen::Index>(u)]);
    return false;
  }

  Eigen::VectorXd values() const {
    Eigen::VectorXd all(static_cast<Eigen::Index>(unknowns_.size()));
    for (std::size_t u = 0; u < unknowns_.size(); ++u)
      all[static_cast<Eigen::Index>(u)] = point_.value(unknowns_[u].column);
    return all;
  }

  double size_of(const Eigen::VectorXd& residual) const {
    double largest = 0.0;
    for (std::size_t e = 0; e < equations_.size(); ++e) {
      const double share =
          std::abs(residual[static_cast<Eigen::Index>(e)]) / (1.0 + std::abs(equations_[e].wanted));
      largest = std::isfinite(share) ? std::max(largest, share) : unbounded;
    }
    return largest;
  }

  Channel channel_of(const Equation& equation) const {
    const std::size_t states = point_.states().size();
    if (!equation.rate) return point_.outputs()[equation.row - states].channel;
    const Channel& state = point_.states()[equation.row].channel;
    return {(point_.sampled() ? "change of " : "d/dt ") + state.name, state.unit};
  }

  WorkingPoint& point_;
  const plan::Plan& plan_;
  std::vector<Unknown> unknowns_;
  std::vector<Equation> equations_;
};

std::vector<WrittenName> names_of(const std::vector<TrimEntry>& entries) {
  std::vector<WrittenName> names;
  for (const TrimEntry& entry : entries) names.push_back(entry.name);
  return names;
}

/// Returns the name by which --set sets a state's initial value.
std::string state_setting(const plan::Plan& plan, const StatePlace& place) {
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const BlockType& type = plan.diagram.blocks[b].type();
    for (std::size_t s = 0; s < type.states.size(); ++s)
      if (plan.blocks[b].states[s].offset == place.offset && plan.blocks[b].states[s].size == 1 &&
          type.states[s].settable)
        return plan.diagram.blocks[b].name + "." + diagram::initial_key(type, type.states[s]);
  }
  return {};
}

/// Returns the name by which --set sets an input: the value of a constant or of a diagram input.
std::string input_setting(const plan::Plan& plan, const WrittenName& written) {
  yaml::Faults none;
  const auto signal = find_wire(plan.diagram, written, none);
  const diagram::DiagramBlock& block = plan.diagram.blocks[static_cast<std::size_t>(signal->signal.block)];
  const bool single = plan.slot(signal->signal).size == 1;
  return single && block.inputs.empty() && block.type().parameter("value") ? block.name + ".value" : "";
}

}  // namespace

TrimResult trim(const diagram::Diagram& diagram, const TrimRequest& request) {
  Request whole{names_of(request.inputs), names_of(request.outputs), {}, request.time, {}};
  whole.whole = true;
  const PreparedDiagram prepared = prepare(diagram, whole);
  if (prepared.inputs.size() != request.inputs.size() || prepared.outputs.size() != request.outputs.size())
    throw yaml::Error(yaml::Fault{{diagram.file, {}},
                                  "trim",
                                  "inputs and outputs are single numbers; name elements of vectors: v.2",
                                  {}});
  WorkingPoint point(prepared, whole);
  Search search(point, request, prepared.plan);
  TrimResult result = search.solve();
  const Eigen::VectorXd here = point.respond();
  const std::size_t states = point.states().size();
  for (std::size_t s = 0; s < states; ++s)
    result.states.push_back({point.states()[s].channel, point.value(s), search.is_free(s), search.at_bound(s),
                             state_setting(prepared.plan, point.states()[s])});
  for (std::size_t i = 0; i < point.inputs().size(); ++i)
    result.inputs.push_back({point.inputs()[i].channel, point.value(states + i), search.is_free(states + i),
                             search.at_bound(states + i),
                             input_setting(prepared.plan, request.inputs[i].name)});
  for (std::size_t o = 0; o < point.outputs().size(); ++o)
    result.outputs.push_back({point.outputs()[o].channel, here[static_cast<Eigen::Index>(states + o)],
                              !request.outputs[o].fixed.has_value(), false, ""});
  return result;
}

}  // namespace stepwire::linear
