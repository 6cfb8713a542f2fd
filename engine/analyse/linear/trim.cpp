#include "engine/analyse/linear/trim.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/linear/slopes.hpp"
#include "engine/analyse/linear/working_point.hpp"
#include "engine/model/diagram/bare_number.hpp"
#include "engine/model/diagram/block_keys.hpp"

namespace stepwire::linear {

using yaml::form;

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
    if (result.converged) result.undetermined = undetermined();
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

  /// Returns how many free numbers the equations leave open: the unknowns less the rank of their slopes.
  std::size_t undetermined() {
    constexpr double share_of_rounding = 1e-6;  // of slopes by differences
    Eigen::MatrixXd slopes = jacobian();
    if (!slopes.allFinite()) return 0;
    for (auto row : slopes.rowwise())
      if (row.norm() > 0.0) row /= row.norm();
    for (auto column : slopes.colwise())
      if (column.norm() > 0.0) column /= column.norm();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(slopes);
    factors.setThreshold(share_of_rounding);
    return unknowns_.size() - static_cast<std::size_t>(slopes.size() > 0 ? factors.rank() : 0);
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

using EntryTable = yaml::KeyTable<TrimEntry, query::NamesReading>;

/// Returns the table of an entry whose numbers have a unit.
EntryTable entry_table(const std::string& unit) {
  const yaml::Key number = form::computed(unit);
  return {
      "a value to be found",
      "{start: 0 m, bounds: [-1 m, 1 m]}",
      {{"fixed", "it is this", number, &TrimEntry::fixed},
       {"start", "from where it is looked for; the file's own value without it", number, &TrimEntry::start},
       {"bounds", "between which it is looked for", form::pair(number),
        [number](TrimEntry& entry, const yaml::Node& node, const query::NamesReading& read) {
          const auto* ends = read.pair(node, yaml::like("[-1 m, 1 m]", {}));
          if (!ends) return;
          const yaml::Node* place = nullptr;
          if (auto fault = diagram::bare_element(node, place)) read.fault(place->mark, std::move(*fault));
          read.take((*ends)[0], number, entry.lower);
          read.take((*ends)[1], number, entry.upper);
        }},
       {"steady", "false, of a state: it may go on changing", form::truth(), &TrimEntry::steady}}};
}

std::string unit_of_number(const plan::Plan& plan, const diagram::SignalRef& signal) {
  const auto dimension = plan.dimension(signal);
  return dimension ? unit::si_name(*dimension) : "";
}

enum class Part { state, input, output };

/// Sets the name of a state: its own, or that of the output that equals it.
void name_state(const plan::Plan& plan, const Signal& signal, TrimEntry& entry, yaml::Faults& faults) {
  const diagram::DiagramBlock& block = plan.diagram.blocks[static_cast<std::size_t>(signal.signal.block)];
  const std::string state = signal.signal.output < 0
                                ? block.type().states[static_cast<std::size_t>(signal.signal.state)].name
                                : block.type().outputs[static_cast<std::size_t>(signal.signal.output)].state;
  if (state.empty())
    return faults.add({entry.name.place,
                       entry.name.subject,
                       yaml::fault_text("'{}' is no state; it stands under 'outputs'", signal.name),
                       {}});
  entry.name.name = block.name + "." + state;
  if (signal.element && plan.slot(signal.signal).size > 1)
    entry.name.name += fmt::format(".{}", *signal.element + 1);
}

/// Adds a fault for an input that depends on other signals.
void require_given(const plan::Plan& plan, const Signal& signal, const TrimEntry& entry,
                   yaml::Faults& faults) {
  if (plan.diagram.blocks[static_cast<std::size_t>(signal.signal.block)].type().inputs.empty()) return;
  faults.add({entry.name.place,
              entry.name.subject,
              yaml::fault_text("'{}' follows from other signals; an input is a constant or an input of the "
                               "diagram, and what another signal is to be stands under 'outputs'",
                               signal.name),
              {}});
}

void read_entry(const yaml::Entry& written, const plan::Plan& plan, Part part,
                const query::NamesReading& read, std::vector<TrimEntry>& entries) {
  TrimEntry entry;
  entry.name = {written.key, {read.names.file, written.mark}, read.subject};
  const auto signal = part == Part::input ? find_wire(plan.diagram, entry.name, read.faults)
                                          : find_signal(plan.diagram, entry.name, read.faults);
  if (!signal) return;
  if (part == Part::state) name_state(plan, *signal, entry, read.faults);
  if (part == Part::input) require_given(plan, *signal, entry, read.faults);
  const query::NamesReading inner = yaml::below(read, written.key);
  const EntryTable table = entry_table(unit_of_number(plan, signal->signal));
  if (written.value.is_map())
    table.read(written.value, entry, inner);
  else if (!(written.value.is_scalar() && written.value.text == "free"))
    inner.take(written.value, table.rows.front(), entry.fixed);
  if (entry.lower && entry.upper && *entry.lower > *entry.upper)
    inner.fault(written.value.mark, "the lower bound comes first");
  entries.push_back(std::move(entry));
}

yaml::Key entries_form(yaml::Key::Names names) {
  return form::naming(
      names, form::names(form::either({form::word({"free"}), form::computed(), entry_table("").form}), 1));
}

struct TrimReading : query::NamesReading {
  const plan::Plan& plan;
  TrimReading(const query::SymbolTable& names, const plan::Plan& plan, yaml::Faults& faults)
      : query::NamesReading("trim", names, faults), plan(plan) {}
};

yaml::KeyRow<TrimRequest, TrimReading> entries_row(std::string name, std::string doc, Part part,
                                                   std::vector<TrimEntry> TrimRequest::*member) {
  return {std::move(name), std::move(doc),
          yaml::like("{cart.position: {fixed: 0 m}}", entries_form(yaml::Key::Names::signal)),
          [=](TrimRequest& request, const yaml::Node& node, const TrimReading& read) {
            if (!node.is_map()) return read.fault(node.mark, "is a map: {cart.position: 0 m}");
            for (const yaml::Entry& entry : node.entries)
              read_entry(entry, read.plan, part, read, request.*member);
          }};
}

const yaml::KeyTable<TrimRequest, TrimReading>& trim_table() {
  static const yaml::KeyTable<TrimRequest, TrimReading> table(
      "the operating point", "{inputs: {push: free}, outputs: {cart.position: 1 m}}",
      {entries_row(
           "states",
           "a number that a state has, `free`, or where it is looked for; those that are not named are "
           "free",
           Part::state, &TrimRequest::states),
       entries_row("inputs",
                   "the same of inputs of the diagram and of constants; those that are not named are as the "
                   "file has them",
                   Part::input, &TrimRequest::inputs),
       entries_row("outputs", "the same of any signal, by which the point is looked for", Part::output,
                   &TrimRequest::outputs),
       {"at", "the time for which sources count", form::computed("s"), &TrimRequest::time}});
  return table;
}

}  // namespace

TrimResult trim(const diagram::Diagram& diagram, const TrimRequest& request) {
  Request whole{names_of(request.inputs), names_of(request.outputs), {}, request.time, {}};
  whole.at = request.at;
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

const yaml::Key& trim_form() {
  return trim_table().form;
}

TrimRequest read_trim(const yaml::Node& node, const query::SymbolTable& names, const plan::Plan& plan,
                      yaml::Faults& faults) {
  TrimRequest request;
  const TrimReading read(names, plan, faults);
  trim_table().read(node, request, read);
  const yaml::Node* const at = node.find("at");
  if (at) request.at = {names.file, at->mark};
  if (const std::string fault = between_ticks(request.time, plan.diagram); at && !fault.empty())
    read.fault(at->mark, fault);
  return request;
}

}  // namespace stepwire::linear
