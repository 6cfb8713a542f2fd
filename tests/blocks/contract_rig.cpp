#include "tests/blocks/contract_rig.hpp"

#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <map>
#include <set>

#include "blocks/register.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire {

namespace {

/// Values of parameters that their declaration alone does not give, or with whose defaults a block does
/// nothing.
const std::map<std::string, std::string> contract_values{
    {"Delay.delay", "5 ms"},
    {"Demux.sizes", "[1, 2]"},
    {"DrivenLinkage.anchors", "[[2, 0], [0, 2], [-1, -1]]"},
    {"DrivenLinkage.pin_mass", "1"},
    {"DrivenLinkage.rod_mass", "0.5"},
    {"DrivenLinkage.rod_centre", "0.1"},
    {"DrivenLinkage.housing_inertia", "0.2"},
    {"FromFile.column", "x"},
    {"FromFile.file", "contract_record.csv"},
    {"FromFile.prepare", "[{low_pass: 100 Hz, order: 2}, {differentiate: 1}]"},
    {"Hysteresis.lower", "0.6"},
    {"Linkage.anchors", "[[2, 0], [0, 2], [-1, -1]]"},
    {"Linkage.pin_mass", "1"},
    {"Linkage.rod_mass", "0.5"},
    {"Linkage.rod_centre", "0.1"},
    {"Linkage.housing_inertia", "0.2"},
    {"InversePolynomial.range", "[0.4, 3]"},
    {"LayerActivator.switches",
     "[{from: 1, to: 2, when: [{enter: 1}, {after: 4 ms}]}, {from: 2, to: 1, when: {leave: 2}}, "
     "{from: 1, to: 2, when: {pass: [0.9, 0.9], within: 0.1}}]"},
    {"LayerActivator.blend", "5 ms"},
    {"LoadCell.calibration",
     "[[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], "
     "[0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]"},
    {"LoadCellToWrench.calibration",
     "[[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], "
     "[0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]"},
    {"MatrixGain.gain", "[[1, 2], [3, 4]]"},
    {"MovingAverage.window", "5 ms"},
    {"GuidePath.trail", "2 mm"},
    {"ReOrigin.margin", "1 mm"},
    {"Reshape.rows", "3"},
    {"Select.indices", "[2, 1]"},
    {"Slice.rows", "[2, 1]"},
    {"Slice.columns", "[1]"},
    {"Interval.lower", "-1"},
    {"Interval.upper", "0.5"},
    {"Proportionality.maximum", "5"},
    {"Proportionality.points", "[0, 1]"},
    {"Proportionality.values", "[0, 4]"},
    {"Pusher.points", "[[0, 0], [3 mm, 1 mm], [0, 2 mm]]"},
    {"Proportionality.offset", "1"},
    {"Proportionality.slope", "2"},
    {"StraightMotion.direction", "[3, 4]"},
    {"StraightMotion.from", "[1, 2]"},
    {"Region.shape", "{union: [{center: [0.5, 0.7], radius: 0.1}, {polygon: [[2, 0], [4, 0], [4, 1]]}]}"},
    {"StateMachine.states",
     "{idle: {output: [1], to: {busy: \"after >= 3 ms\"}}, "
     "busy: {output: [2], history: true, enter: {n: n + 1}, to: {idle: \"after >= 6 ms || u1 > 1.2\"}, "
     "states: {slow: {to: {fast: \"after >= 2 ms\"}}, fast: {each: {n: n + u1}, to: {slow: \"after >= 50 "
     "ms\"}}}}}"},
    {"StateMachine.counters", "{n: 0}"},
    {"DiscreteStateSpace.A", "[[0.5, 0.2], [0, 0.3]]"},
    {"DiscreteStateSpace.B", "[[1], [1]]"},
    {"DiscreteStateSpace.C", "[[1, 1]]"},
    {"KalmanFilter.A", "[[0.5, 0.2], [0, 0.3]]"},
    {"KalmanFilter.B", "[[1], [1]]"},
    {"KalmanFilter.C", "[[1, 1]]"},
    {"KalmanFilter.Q", "[[1, 0.1], [0.1, 2]]"},
    {"KalmanFilter.R", "[[0.5]]"},
    {"KalmanFilter.P0", "[[2, 0], [0, 2]]"},
    {"DiscreteLuenbergerObserver.A", "[[0.5, 0.2], [0, 0.3]]"},
    {"DiscreteLuenbergerObserver.B", "[[1], [1]]"},
    {"DiscreteLuenbergerObserver.C", "[[1, 1]]"},
    {"DiscreteLuenbergerObserver.L", "[[0.1], [0.2]]"},
    {"LuenbergerObserver.A", "[[-1, 2], [0, -3]]"},
    {"LuenbergerObserver.B", "[[1], [1]]"},
    {"LuenbergerObserver.C", "[[1, 1]]"},
    {"LuenbergerObserver.L", "[[0.1], [0.2]]"},
    {"LookupTableND.points", "[[0, 1], [0, 1, 2]]"},
    {"LookupTableND.values", "[[1, 2, 4], [3, 5, 7]]"},
    {"StateSpace.A", "[[-1, 2], [0, -3]]"},
    {"StateSpace.B", "[[1], [1]]"},
    {"StateSpace.C", "[[1, 1]]"},
    {"StuckDetector.time", "3 ms"},
    {"StuckDetector.tolerance", "1"},
};

/// Sizes that an input needs where nothing else fixes them.
const std::map<std::string, int> contract_sizes{{"Cross.u", 3},
                                                {"Demux.u", 3},
                                                {"DiscreteLuenbergerObserver.initial", 2},
                                                {"DiscreteLuenbergerObserver.value", 2},
                                                {"DiscreteStateSpace.initial", 2},
                                                {"DiscreteStateSpace.value", 2},
                                                {"KalmanFilter.initial", 2},
                                                {"KalmanFilter.value", 2},
                                                {"LuenbergerObserver.initial", 2},
                                                {"LuenbergerObserver.value", 2},
                                                {"QuaternionIntegrator.initial", 4},
                                                {"QuaternionIntegrator.rate", 3},
                                                {"QuaternionIntegrator.value", 4},
                                                {"QuaternionProduct.left", 4},
                                                {"QuaternionProduct.right", 4},
                                                {"Rotate3D.angles", "RotationMatrix.angles", 3},
                                                {"Rotate3D.axis", 3},
                                                {"Rotate3D.quaternion", 4},
                                                {"Rotate3D.u", 3},
                                                {"StateSpace.initial", 2},
                                                {"StateSpace.value", 2},
                                                {"DrivenLinkage.acceleration", 2},
                                                {"DrivenLinkage.force", 3},
                                                {"DrivenLinkage.position", 2},
                                                {"DrivenLinkage.torque", 3},
                                                {"DrivenLinkage.velocity", 2},
                                                {"LayerActivator.position", 2},
                                                {"Linkage.external", 2},
                                                {"Linkage.force", 3},
                                                {"Linkage.torque", 3},
                                                {"LoadCell.force", 3},
                                                {"LoadCell.torque", 3},
                                                {"LoadCellToWrench.gauges", 6},
                                                {"Reshape.u", 3},
                                                {"Rotate.u", 2},
                                                {"RotationMatrix.angles", 3},
                                                {"RotationMatrix.axis", 3},
                                                {"RotationMatrix.quaternion", 4},
                                                {"Select.u", 3},
                                                {"Slice.u", 2}};

/// Where what feeds an input starts, on its way to 1; else at a half and more.
const std::map<std::string, double> contract_starts{{"Interlock.faults", -1.9}};

/// Optional inputs that the values above need.
const std::set<std::string> contract_inputs{"Directionality.force", "LayerActivator.regions",
                                            "Rotate3D.angles", "RotationMatrix.angles", "StateMachine.u"};

std::string value_given(const BlockType& type, const ParameterSpec& spec) {
  const std::string name = type.name + "." + spec.name;
  if (const auto known = contract_values.find(name); known != contract_values.end()) return known->second;
  if (spec.kind == ParameterKind::word && !spec.words.empty()) return "\"" + spec.words.front() + "\"";
  if (spec.kind == ParameterKind::number || spec.kind == ParameterKind::integer ||
      spec.kind == ParameterKind::per_element)
    return fmt::format("{}", spec.range.at_least.value_or(1.0));
  throw std::logic_error("give a value for " + name + " in contract_values");
}

/// Writes the blocks that feed the inputs, and the keys of the inputs.
class Feeds {
 public:
  std::string feed(const BlockType& type, const InputSpec& input) {
    const auto size = contract_sizes.find(type.name + "." + input.name);
    const int elements = size == contract_sizes.end() ? 1 : size->second;
    const auto known = contract_starts.find(type.name + "." + input.name);
    const double start = known == contract_starts.end() ? 0.5 : known->second;
    if (!input.list) return one(elements, start);
    const std::string first = one(elements, start);
    return "[" + first + ", " + one(elements, start) + "]";
  }
  const std::string& blocks() const { return blocks_; }

 private:
  std::string one(int elements, double first) {
    std::string start = fmt::format("{}", first + 0.05 * count_);
    for (int k = 1; k < elements; ++k) start += k % 2 == 1 ? ", 0.7" : ", 0.3";
    if (elements > 1) start = "[" + start + "]";
    const std::string name = fmt::format("feed_{}", count_++);
    blocks_ += fmt::format("  {}: {{block: Lag, u: 1, tau: 20 ms, initial: {}}}\n", name, start);
    return name;
  }

  int count_ = 0;
  std::string blocks_;
};

bool is_fed(const BlockType& type, const InputSpec& input, bool optional_inputs) {
  return !input.optional || optional_inputs || contract_inputs.contains(type.name + "." + input.name);
}

bool is_given(const BlockType& type, const ParameterSpec& spec) {
  return spec.required || contract_values.contains(type.name + "." + spec.name);
}

std::string diagram_text(const BlockType& type, bool optional_inputs, const std::string& more) {
  Feeds feeds;
  std::string keys = "block: " + type.name;
  for (const InputSpec& input : type.inputs)
    if (is_fed(type, input, optional_inputs))
      keys += fmt::format(", {}: {}", input.name, feeds.feed(type, input));
  for (const ParameterSpec& spec : type.parameters)
    if (is_given(type, spec) && !more.starts_with(", " + spec.name + ":"))
      keys += fmt::format(", {}: {}", spec.name, value_given(type, spec));
  return fmt::format(
      "stepwire: 1\ntitle: {}\nstep: 1 ms\nstop: 20 ms\nsolver: rk4\nblocks:\n{}  tested: {{{}{}}}\n",
      type.name, feeds.blocks(), keys, more);
}

bool has_optional_input(const BlockType& type) {
  for (const InputSpec& input : type.inputs)
    if (input.optional) return true;
  return false;
}

void add_choices(const BlockType& type, bool optional_inputs, std::vector<Wiring>& wirings) {
  for (const ParameterSpec& spec : type.parameters)
    for (const std::string& word : spec.words)
      wirings.push_back(
          {diagram_text(type, optional_inputs, fmt::format(", {}: \"{}\"", spec.name, word)), true});
  for (const PresetSpec& preset : type.presets)
    wirings.push_back({diagram_text(type, optional_inputs, ", preset: " + preset.name)});
}

}  // namespace

const Registry& library() {
  static const Registry registry = blocks();
  return registry;
}

std::vector<Wiring> wirings_of(const BlockType& type) {
  std::vector<Wiring> wirings{{diagram_text(type, false, "")}};
  add_choices(type, false, wirings);
  if (!has_optional_input(type)) return wirings;
  wirings.push_back({diagram_text(type, true, "")});
  add_choices(type, true, wirings);
  return wirings;
}

Wiring guarded(const Wiring& wiring, const std::string& enable) {
  Wiring made = wiring;
  const std::string tested = "  tested: {";
  made.text.replace(
      made.text.rfind(tested), tested.size(),
      "  gate: {block: Pulse, period: 5 ms, width: 60 %}\n" + tested + "enable: " + enable + ", ");
  return made;
}

std::optional<plan::Plan> plan_of(const Wiring& wiring) {
  diagram::Loader loader(library());
  const auto beside = std::filesystem::path(STEPWIRE_SOURCE_DIR) / "tests" / "blocks" / "contract.yaml";
  try {
    return plan::make_plan(loader.load_text(wiring.text, beside.string()));
  } catch (const yaml::Error&) {
    if (!wiring.may_be_refused) throw;
    return std::nullopt;
  }
}

std::size_t tested_in(const plan::Plan& plan) {
  for (std::size_t i = 0; i < plan.diagram.blocks.size(); ++i)
    if (plan.diagram.blocks[i].name == "tested") return i;
  throw std::logic_error("the diagram has no block 'tested'");
}

bool feeds_through(const plan::Plan& plan, std::size_t input, std::size_t output) {
  const diagram::DiagramBlock& block = plan.diagram.blocks[tested_in(plan)];
  const BlockType& type = block.type();
  if (!type.configure) return type.inputs[input].feedthrough;
  std::set<std::string> connected;
  std::map<std::string, Eigen::Index> counts;
  for (std::size_t i = 0; i < type.inputs.size(); ++i) {
    if (!block.inputs[i].empty()) connected.insert(type.inputs[i].name);
    counts[type.inputs[i].name] = static_cast<Eigen::Index>(block.inputs[i].size());
  }
  AnyBlock copy = block.block;
  Configure is(connected, plan.diagram.step, counts);
  type.configure(copy.get(), is);
  const auto said = is.answers().feedthrough.find({type.inputs[input].name, type.outputs[output].name});
  return said == is.answers().feedthrough.end() ? type.inputs[input].feedthrough : said->second;
}

std::vector<double> numbers_of(const run::Executor& simulation) {
  return simulation.workspace().values;
}

std::vector<double> output_of(const run::Executor& simulation, std::size_t output) {
  const plan::Plan& plan = simulation.plan();
  const plan::SignalSlot& slot = plan.blocks[tested_in(plan)].outputs[output];
  const double* first = simulation.values() + slot.offset;
  return {first, first + slot.size};
}

bool same_numbers(const plan::Plan& plan, const double* a, const double* b) {
  const plan::Layout& layout = plan.layout;
  const auto same = [&](std::size_t first, std::size_t end) {
    return std::memcmp(a + first, b + first, (end - first) * sizeof(double)) == 0;
  };
  return same(layout.signals, layout.derivatives) &&
         same(layout.discrete, layout.discrete + layout.discrete_count) &&
         same(layout.diagnostics, layout.diagnostics + layout.diagnostic_count);
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace stepwire
