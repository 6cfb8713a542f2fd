#include "engine/analyse/linear/linearize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/linear/slopes.hpp"
#include "engine/analyse/linear/working_point.hpp"

namespace stepwire::linear {

namespace {

constexpr std::size_t most_notes = 12;

/// Differentiates the columns of a working point one by one.
class Columns {
 public:
  Columns(WorkingPoint& point, const Request& request)
      : point_(point), request_(request), stride_(work() > much ? 4 : 1) {}

  std::vector<Slopes> take() {
    std::vector<Slopes> all;
    for (std::size_t column = 0; column < point_.columns(); ++column) all.push_back(slopes(column));
    while (remove_one(all)) {
    }
    return all;
  }

  std::vector<std::string> notes;

 private:
  Slopes slopes(std::size_t column) {
    return slopes_of([&](double value) { return point_.respond(column, value); }, point_.value(column),
                     {request_.size, point_.most_change(column), stride_});
  }

  /// Removes one state that cannot be a state of a linear system. A counter or flag makes other numbers jump.
  /// A private state that nothing depends on has no effect: the value after a reset, or memory that each
  /// update overwrites. Returns false if there is none.
  bool remove_one(std::vector<Slopes>& all) {
    for (std::size_t s = 0; s < point_.states().size(); ++s) {
      const StatePlace& state = point_.states()[s];
      const bool jumps = std::ranges::find(all[s].jumps, true) != all[s].jumps.end();
      const bool leaves =
          (jumps && state.may_count) || (state.own && (is_alone(all, s) || is_overwritten(all[s])));
      if (!leaves) continue;
      if (jumps) notes.push_back(state.channel.name + " is held: with another value of it numbers jump");
      point_.remove_state(s);
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(s));
      for (Slopes& slopes : all) slopes.erase(static_cast<Eigen::Index>(s));
      return true;
    }
    return false;
  }

  /// True if neither the state itself nor anything else a base period later depends on it.
  static bool is_overwritten(const Slopes& slopes) {
    return slopes.value.isZero(0.0) && !slopes.left.array().isFinite().any() &&
           !slopes.farther.array().isFinite().any();
  }

  static bool is_alone(const std::vector<Slopes>& all, std::size_t s) {
    const auto row = static_cast<Eigen::Index>(s);
    for (std::size_t column = 0; column < all.size(); ++column)
      if (column != s && all[column].value[row] != 0.0) return false;
    Eigen::VectorXd others = all[s].value;
    others[row] = 0.0;
    return others.isZero(0.0);
  }

  /// Returns the number of block calls for one size of differences.
  double work() const {
    return static_cast<double>(point_.columns()) * static_cast<double>(point_.base_ticks()) *
           static_cast<double>(point_.paths().samples.size());
  }
  static constexpr double much = 1e6;  ///< Limit, some seconds for all sizes.

  WorkingPoint& point_;
  const Request& request_;
  int stride_;
};

std::string row_name(const WorkingPoint& point, std::size_t row) {
  const std::size_t states = point.states().size();
  if (row >= states) return point.outputs()[row - states].channel.name;
  const std::string& name = point.states()[row].channel.name;
  return point.sampled() ? "the next " + name : "d/dt " + name;
}

std::string column_name(const WorkingPoint& point, std::size_t column) {
  const std::size_t states = point.states().size();
  return column < states ? point.states()[column].channel.name : point.inputs()[column - states].channel.name;
}

/// Returns the remark on a number that is not smooth; empty for a smooth one.
std::string roughness(const std::string& of, const Slopes& slopes, Eigen::Index row) {
  if (slopes.jumps[static_cast<std::size_t>(row)])
    return fmt::format("not smooth: {} jumps at this point", of);
  if (std::isfinite(slopes.left[row]))
    return fmt::format("not smooth: {} has the slope {:.4g} from below and {:.4g} from above", of,
                       slopes.left[row], slopes.right[row]);
  if (std::isfinite(slopes.nearer[row]))
    return fmt::format(
        "differences of two sizes disagree: {} has the slope {:.4g} over large ones and {:.4g} "
        "over small ones (steps?)",
        of, slopes.value[row], slopes.nearer[row]);
  if (std::isfinite(slopes.farther[row]))
    return fmt::format(
        "{} is flat at this point, and has the slope {:.4g} over large differences (steps, or "
        "play): --difference 0.01 takes such ones",
        of, slopes.farther[row]);
  if (!(slopes.error[row] <= 1e-5 * std::abs(slopes.value[row])) && slopes.error[row] > 1e-9)
    return fmt::format("differences disagree: {} is {:.6g} give or take {:.2g}", of, slopes.value[row],
                       slopes.error[row]);
  return {};
}

void note_roughness(const WorkingPoint& point, const std::vector<Slopes>& all,
                    std::vector<std::string>& notes) {
  for (std::size_t column = 0; column < all.size(); ++column)
    for (Eigen::Index row = 0; row < all[column].value.size(); ++row) {
      const std::string of = fmt::format("{} over {}", row_name(point, static_cast<std::size_t>(row)),
                                         column_name(point, column));
      if (std::string note = roughness(of, all[column], row); !note.empty()) notes.push_back(std::move(note));
    }
  if (notes.size() <= most_notes) return;
  const std::size_t more = notes.size() - most_notes;
  notes.resize(most_notes);
  notes.push_back(fmt::format("and {} more of this kind", more));
}

/// Adds a note on sampled blocks near the paths, but not on them; they keep their state. So do delays beside
/// a sampled system.
void note_held(const WorkingPoint& point, const plan::Plan& plan, std::vector<std::string>& notes) {
  std::vector<std::string> held;
  const Paths& paths = point.paths();
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = plan.diagram.blocks[b];
    const bool is_held = paths.samples[b] || (point.sampled() && !block.type().delayed_by.empty());
    if (is_held && paths.near_way(b) && !paths.on_way(b)) held.push_back(block.name);
  }
  if (held.empty()) return;
  notes.push_back(fmt::format("not on the way from inputs to outputs, so without states here: {}",
                              fmt::join(held, ", ")));
}

std::string method_text(const WorkingPoint& point, const plan::Plan& plan, const Request& request) {
  const std::string how = request.size
                              ? fmt::format("central differences of {:g} of each number", *request.size)
                              : "central differences, extrapolated";
  if (!point.sampled())
    return point.delays().empty() ? how
                                  : how + "; delays are exact, and lie between their own outputs and inputs";
  const bool stepped = !plan.diagram.solver.empty() && plan.layout.state_count > 0;
  return fmt::format("map of one base period of {:g} s by {}; inputs are held over it{}",
                     static_cast<double>(point.base_ticks()) * plan.diagram.step, how,
                     stepped ? fmt::format(", and between samples {} steps the continuous states by {:g} s",
                                           plan.diagram.solver, plan.diagram.step)
                             : "");
}

/// Returns the matrices: rows are states and outputs, columns are states and inputs.
StateSpace parted(const WorkingPoint& point, const std::vector<Slopes>& all,
                  Eigen::VectorXd Slopes::*numbers) {
  const auto n = static_cast<Eigen::Index>(point.states().size());
  const auto m = static_cast<Eigen::Index>(point.inputs().size());
  const auto p = static_cast<Eigen::Index>(point.outputs().size());
  Eigen::MatrixXd whole(n + p, n + m);
  for (Eigen::Index column = 0; column < n + m; ++column)
    whole.col(column) = all[static_cast<std::size_t>(column)].*numbers;
  StateSpace system{whole.topLeftCorner(n, n),
                    whole.topRightCorner(n, m),
                    whole.bottomLeftCorner(p, n),
                    whole.bottomRightCorner(p, m),
                    {},
                    {},
                    {},
                    0.0};
  for (const StatePlace& state : point.states()) system.states.push_back(state.channel);
  const std::size_t delays = point.delays().size(), inputs = point.inputs().size() - delays,
                    outputs = point.outputs().size() - delays;
  for (std::size_t i = 0; i < inputs; ++i) system.inputs.push_back(point.inputs()[i].channel);
  for (std::size_t o = 0; o < outputs; ++o) system.outputs.push_back(point.outputs()[o].channel);
  for (std::size_t k = 0; k < delays; ++k)
    system.delays.push_back({0.0, point.outputs()[outputs + k].channel, point.inputs()[inputs + k].channel});
  return system;
}

void put_delays(WorkingPoint& point, Linearization& result) {
  for (std::size_t k = 0; k < point.delays().size(); ++k) {
    const TakenDelay& taken = point.delays()[k];
    InnerDelay& delay = result.system.delays[k];
    delay.time = std::max(taken.shortest, point.number(taken.length));
    if (taken.source >= 0 && point.paths().from_inputs[static_cast<std::size_t>(taken.source)])
      result.notes.push_back(
          fmt::format("the time between {} and {} is held at {:g} s, though it depends on the inputs",
                      delay.out.name, delay.in.name, delay.time));
  }
  if (!point.delays().empty())
    result.notes.push_back(
        "a delay has poles and zeros without end: the poles nearest to 0 are found, and no zeros or ranks");
}

void put_point(WorkingPoint& point, Linearization& result) {
  const Eigen::VectorXd here = point.respond();
  const std::size_t states = point.states().size();
  for (std::size_t s = 0; s < states; ++s) {
    result.states.push_back({point.states()[s].channel, point.value(s)});
    const double going = here[static_cast<Eigen::Index>(s)];
    result.rates.push_back(point.sampled() ? going - point.value(s) : going);
  }
  for (std::size_t i = 0; i < result.system.inputs.size(); ++i)
    result.inputs.push_back({point.inputs()[i].channel, point.value(states + i)});
  for (std::size_t o = 0; o < result.system.outputs.size(); ++o)
    result.outputs.push_back({point.outputs()[o].channel, here[static_cast<Eigen::Index>(states + o)]});
}

void note_motion(const WorkingPoint& point, Linearization& result) {
  std::size_t fastest = 0;
  const auto share = [&](std::size_t s) {
    return std::abs(result.rates[s]) / (1.0 + std::abs(result.states[s].value));
  };
  for (std::size_t s = 1; s < result.rates.size(); ++s)
    if (share(s) > share(fastest)) fastest = s;
  if (result.rates.empty() || share(fastest) < 1e-6) return;
  const std::string& unit = result.states[fastest].channel.unit;
  result.notes.push_back(fmt::format("the point is no equilibrium: {} changes by {:.4g}{}{}",
                                     result.states[fastest].channel.name, result.rates[fastest],
                                     unit.empty() ? "" : " " + unit,
                                     point.sampled() ? " in a base period" : " per s"));
}

/// Throws Error for more states than matrices can have.
void refuse_too_many(const WorkingPoint& point, const plan::Plan& plan) {
  constexpr std::size_t most = 4000;
  if (point.states().size() <= most) return;
  const auto states_of = [&](const diagram::DiagramBlock& block) {
    return std::ranges::count_if(point.states(), [&](const StatePlace& state) {
      return state.channel.name.starts_with(block.name + ".");
    });
  };
  const diagram::DiagramBlock& block = *std::ranges::max_element(plan.diagram.blocks, {}, states_of);
  throw yaml::Error(plan.diagram.fault(
      block.origin, block.name,
      fmt::format("a linear system has at most {} states, and this block alone {}; give it a longer period "
                  "'every', or take a TransportDelay among continuous blocks, which needs none",
                  most, states_of(block))));
}

}  // namespace

Linearization linearize(diagram::Diagram diagram, const Request& request) {
  const PreparedDiagram prepared = prepare(std::move(diagram), request);
  WorkingPoint point(prepared, request);
  refuse_too_many(point, prepared.plan);
  Columns columns(point, request);
  const std::vector<Slopes> all = columns.take();
  Linearization result;
  result.system = parted(point, all, &Slopes::value);
  result.error = parted(point, all, &Slopes::error);
  result.time = point.time();
  result.feedback = prepared.feedback;
  if (point.sampled())
    result.system.sample_time = static_cast<double>(point.base_ticks()) * prepared.plan.diagram.step;
  result.method = method_text(point, prepared.plan, request);
  put_delays(point, result);
  put_point(point, result);
  note_roughness(point, all, result.notes);
  std::ranges::move(columns.notes, std::back_inserter(result.notes));
  if (!point.counts().empty())
    result.notes.push_back(
        fmt::format("counters and marks that stay as the run has them: {}", fmt::join(point.counts(), ", ")));
  note_held(point, prepared.plan, result.notes);
  note_motion(point, result);
  return result;
}

}  // namespace stepwire::linear
