// Fields of the results of a linear analysis and of a trim.
#include <cmath>

#include "engine/analyse/linear/analysis.hpp"
#include "engine/analyse/linear/trim.hpp"

namespace stepwire::linear {

using result::Map;
using result::Record;

namespace {

std::vector<std::string> names_of(const std::vector<Channel>& channels) {
  std::vector<std::string> names;
  for (const Channel& channel : channels) names.push_back(channel.name);
  return names;
}

std::vector<std::string> units_of(const std::vector<Channel>& channels) {
  std::vector<std::string> units;
  for (const Channel& channel : channels) units.push_back(channel.unit);
  return units;
}

/// Returns a value, or std::nullopt for a system with delays, of which it is unknown.
template <class Value>
std::optional<Value> without_delays(const Analysis& analysis, Value value) {
  return analysis.system.delays.empty() ? std::optional(std::move(value)) : std::nullopt;
}

std::optional<bool> stable_if_known(const Analysis& analysis) {
  return analysis.stability.known ? std::optional(analysis.stability.stable) : std::nullopt;
}

Map<double> values_of(const std::vector<PointValue>& values) {
  Map<double> map;
  for (const PointValue& value : values) map.emplace_back(value.channel.name, value.value);
  return map;
}

}  // namespace

/// Margins with the sign of the feedback.
struct LoopMargins : Margins {
  double feedback;

  std::optional<Crossing> nearest(const std::optional<Crossing>& crossing, bool known) const {
    return known && knows_stability ? crossing : std::nullopt;
  }
};

/// Analysis of a channel, with that of the system.
struct ChannelOf : ChannelAnalysis {
  const Analysis* all;
};

static void declare(Record<Mode>& is) {
  is.named("Mode", "A pole with its frequency and damping.");
  is.field("pole", &Mode::pole, "pole", "rad/s");
  is.field("natural_frequency", &Mode::frequency, "natural frequency", "rad/s");
  is.field("damping", &Mode::damping, "damping ratio");
}

static void declare(Record<Crossing>& is) {
  is.named("Crossing", "A change of gain or phase that puts the closed loop on the border of stability.");
  is.field("frequency", &Crossing::frequency, "frequency; null for a direct path", "rad/s");
  is.field("margin", &Crossing::margin, "factor of the gain, angle [rad] of the phase, or distance from -1");
}

static void declare(Record<LoopMargins>& is) {
  is.named("Margins", "Margins of the loop that feedback closes.");
  is.field("feedback", &LoopMargins::feedback, "sign of the feedback, +1 or -1");
  is.field(
      "stable",
      [](const LoopMargins& is) { return is.knows_stability ? std::optional(is.stable) : std::nullopt; },
      "stability of the closed loop; null if undetermined");
  is.field(
      "gain", [](const LoopMargins& is) { return is.nearest(is.worst_gain(), is.knows_gain); },
      "crossing with the factor nearest to 1");
  is.field(
      "phase", [](const LoopMargins& is) { return is.nearest(is.worst_phase(), is.knows_phase); },
      "crossing with the angle nearest to 0");
  is.field("delay", &LoopMargins::delay, "least delay that uses up the phase margin", "s");
  is.field(
      "modulus",
      [](const LoopMargins& is) {
        return is.knows_modulus ? std::optional(Crossing{is.modulus_frequency, is.modulus}) : std::nullopt;
      },
      "least distance of the loop gain from -1");
  is.field("gain_crossings", &LoopMargins::gain, "crossings of the gain");
  is.field("gain_crossings_up_to", &LoopMargins::gain_up_to,
           "frequency up to which they are listed; null: all are", "rad/s");
  is.field("gain_crossings_left_out", &LoopMargins::gain_left_out,
           "number of those below it that are not listed");
  is.field("phase_crossings", &LoopMargins::phase, "all crossings of the phase");
  is.field("closed_poles", &LoopMargins::closed_poles, "poles of the closed loop", "rad/s");
  is.field("not_determined", &LoopMargins::notes, "a sentence on each undetermined value");
}

static void declare(Record<ChannelOf>& is) {
  is.named("ChannelAnalysis", "Analysis of one input and one output.");
  is.field("input", &ChannelOf::input, "name of the input");
  is.field("output", &ChannelOf::output, "name of the output");
  is.field(
      "zeros", [](const ChannelOf& is) { return without_delays(*is.all, is.zeros); },
      "zeros; null for a system with delays", "rad/s");
  is.field("gain_at_rest", &ChannelOf::gain_at_rest, "gain at frequency 0", "SI");
  is.field("bandwidth", &ChannelOf::bandwidth, "bandwidth", "rad/s");
  is.field(
      "margins",
      [](const ChannelOf& is) {
        return LoopMargins{is.margins, is.all->feedback};
      },
      "margins of the loop of this channel");
}

static void declare(Record<Rank>& is) {
  is.named("Rank", "Number of state directions that inputs control, or that outputs observe.");
  is.field("rank", &Rank::rank, "number of directions");
  is.field("singular_values", &Rank::singular_values, "singular values, the largest first");
  is.field("certain", &Rank::certain, "false where rounding may hide or add a direction");
}

static void declare(Record<InnerDelay>& is) {
  is.named("InnerDelay", "A delay from an additional output to an additional input of the system.");
  is.field("time", &InnerDelay::time, "delay", "s");
  is.field("output", result::path(&InnerDelay::out, &Channel::name), "output into the delay");
  is.field("input", result::path(&InnerDelay::in, &Channel::name), "input out of the delay");
}

static void declare(Record<StateSpace>& is) {
  is.named("ChannelUnits", "SI units of states, inputs and outputs.");
  is.field(
      "states", [](const StateSpace& of) { return units_of(of.states); }, "of the states");
  is.field(
      "inputs", [](const StateSpace& of) { return units_of(of.all_inputs()); }, "of the inputs");
  is.field(
      "outputs", [](const StateSpace& of) { return units_of(of.all_outputs()); }, "of the outputs");
}

/// Error of the matrices.
struct MatrixErrors : StateSpace {};

/// Operating point of an analysis.
struct PointOf : Linearization {};

namespace {

/// Adds the four matrices of a state space to a record.
template <class Struct, class Get>
void add_matrices(Record<Struct>& is, Get of, const std::string& what) {
  const auto add = [&](const char* name, Eigen::MatrixXd StateSpace::*matrix, const char* doc) {
    is.field(
        name, [of, matrix](const Struct& is) { return of(is).*matrix; }, what + doc, "SI");
  };
  add("A", &StateSpace::A, "from the states to their derivatives");
  add("B", &StateSpace::B, "from the inputs to the derivatives");
  add("C", &StateSpace::C, "from the states to the outputs");
  add("D", &StateSpace::D, "from the inputs to the outputs");
}

}  // namespace

static void declare(Record<MatrixErrors>& is) {
  is.named("MatrixErrors", "Estimated errors of the matrices.");
  add_matrices(
      is, [](const MatrixErrors& is) -> const StateSpace& { return is; }, "error of the matrix ");
}

static void declare(Record<PointOf>& is) {
  is.named("OperatingPoint", "Values at which a diagram is linearized.");
  is.field("time", &PointOf::time, "time", "s");
  is.field(
      "states", [](const PointOf& is) { return values_of(is.states); }, "states", "SI");
  is.field("rates", &PointOf::rates, "derivatives of the states, or their change in a sample time", "SI");
  is.field(
      "inputs", [](const PointOf& is) { return values_of(is.inputs); }, "inputs", "SI");
  is.field(
      "outputs", [](const PointOf& is) { return values_of(is.outputs); }, "outputs", "SI");
}

namespace {

std::vector<ChannelOf> channels_of(const Analysis& analysis) {
  std::vector<ChannelOf> channels;
  for (const ChannelAnalysis& channel : analysis.channels) channels.push_back({channel, &analysis});
  return channels;
}

void add_system(Record<Analysis>& is) {
  add_matrices(
      is, [](const Analysis& of) -> const StateSpace& { return of.system; }, "matrix ");
  is.field(
      "states", [](const Analysis& of) { return names_of(of.system.states); }, "names of the states");
  is.field(
      "inputs", [](const Analysis& of) { return names_of(of.system.all_inputs()); },
      "names of the inputs, then those of the delays");
  is.field(
      "outputs", [](const Analysis& of) { return names_of(of.system.all_outputs()); },
      "names of the outputs, then those of the delays");
  is.field("delays", result::path(&Analysis::system, &StateSpace::delays), "delays within the system");
  is.field("units", &Analysis::system, "SI units");
  is.field("sample_time", result::path(&Analysis::system, &StateSpace::sample_time),
           "sample time; 0 for a continuous system", "s");
}

std::vector<Complex> pole_list(const Analysis& analysis) {
  std::vector<Complex> poles;
  for (const Mode& mode : analysis.modes) poles.push_back(mode.pole);
  return poles;
}

std::optional<LoopMargins> only_margins(const Analysis& of) {
  if (!of.system.has_one_channel()) return std::nullopt;
  return LoopMargins{of.channels[0].margins, of.feedback};
}

}  // namespace

void declare(Record<Analysis>& is) {
  is.named("LinearResult", "The result of a linear analysis: linear.json.");
  is.field("file", &Analysis::file, "diagram file");
  add_system(is);
  is.field("poles", pole_list, "poles", "rad/s");
  is.field(
      "zeros", [](const Analysis& of) { return without_delays(of, of.zeros); },
      "transmission zeros; null for a system with delays", "rad/s");
  is.field("modes", &Analysis::modes, "poles with frequency and damping");
  is.field("stable", stable_if_known, "stability without feedback; null if undetermined");
  is.field(
      "controllability", [](const Analysis& of) { return without_delays(of, of.controllable); },
      "states that the inputs control; null for a system with delays");
  is.field(
      "observability", [](const Analysis& of) { return without_delays(of, of.observable); },
      "states that the outputs observe; null for a system with delays");
  is.field("channels", channels_of, "each output of the first input, then of the second, ...");
  is.omitted("margins", only_margins, "margins of the only channel; missing with several");
  is.field(
      "point", [](const Analysis& of) { return PointOf{of}; }, "operating point");
  is.field(
      "error", [](const Analysis& of) { return MatrixErrors{of.error}; }, "estimated errors");
  is.field("method", &Analysis::method, "sentence on the method");
  is.field("notes", &Analysis::notes, "kinks, held values, a point that is no equilibrium");
}

static void declare(Record<TrimmedValue>& is) {
  is.named("TrimmedValue", "A number of the operating point.");
  is.field("name", result::path(&TrimmedValue::channel, &Channel::name),
           "name of the state, input or output");
  is.field("value", &TrimmedValue::value, "value", "SI");
  is.field(
      "unit", [](const TrimmedValue& of) { return result::text_if_any(of.channel.unit); },
      "SI unit; null if unknown or dimensionless");
  is.field("free", &TrimmedValue::free, "true if the search determines it");
  is.field("at_bound", &TrimmedValue::at_bound, "true at a bound");
  is.field(
      "setting", [](const TrimmedValue& of) { return result::text_if_any(of.setting); },
      "name for --set; null if no file can set it");
}

/// Residual of a trim.
struct NamedResidual {
  std::string name;
  double value;
};

static void declare(Record<NamedResidual>& is) {
  is.named("Residual", "A derivative, or an output minus its target.");
  is.field("name", &NamedResidual::name, "name of the state or output");
  is.field("value", &NamedResidual::value, "residual", "SI");
}

namespace {

std::vector<NamedResidual> residuals_of(const TrimResult& result) {
  std::vector<NamedResidual> all;
  for (const auto& [channel, value] : result.residuals) all.push_back({channel.name, value});
  return all;
}

}  // namespace

void declare(Record<TrimResult>& is) {
  is.named("TrimResult", "The result of a trim: trim.json.");
  is.field("file", &TrimResult::file, "diagram file");
  is.field("converged", &TrimResult::converged, "true at an operating point");
  is.field("iterations", &TrimResult::iterations, "number of iterations");
  is.field("residual", &TrimResult::largest, "largest residual, each as a share of 1 or of its number");
  is.field("undetermined", &TrimResult::undetermined,
           "number of free numbers that the conditions leave open: above 0 the point is one of many");
  is.field("states", &TrimResult::states, "states");
  is.field("inputs", &TrimResult::inputs, "inputs");
  is.field("outputs", &TrimResult::outputs, "outputs");
  is.field("residuals", residuals_of, "derivatives, and outputs minus their targets");
}

}  // namespace stepwire::linear
