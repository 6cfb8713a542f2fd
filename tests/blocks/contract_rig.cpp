#include "tests/blocks/contract_rig.hpp"

#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <map>
#include <set>

#include "engine/model/diagram/load.hpp"
#include "tests/blocks/contract_tables.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/units/units.hpp"

namespace stepwire {

namespace {

/// A unit, packed once for all blocks that need one.
std::string unit_file() {
  static const Scratch scratch;
  static const std::string path =
      testing::write_zip(scratch.path("contract.fmu"), testing::unit_of_3("dahlquist"));
  return path;
}

std::string value_given(const BlockType& type, const ParameterSpec& spec) {
  const std::string name = type.name + "." + spec.name;
  if (name == "Fmu.file") return unit_file();
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
  /// Sets the number of elements of signals whose size is free.
  explicit Feeds(int elements) : elements_(elements) {}

  std::string feed(const BlockType& type, const InputSpec& input) {
    const auto size = contract_sizes.find(type.name + "." + input.name);
    const int elements = size == contract_sizes.end() ? elements_ : size->second;
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

  int elements_, count_ = 0;
  std::string blocks_;
};

bool is_fed(const BlockType& type, const InputSpec& input, bool optional_inputs) {
  return !input.optional || optional_inputs || contract_inputs.contains(type.name + "." + input.name);
}

bool is_given(const BlockType& type, const ParameterSpec& spec) {
  return spec.required || contract_values.contains(type.name + "." + spec.name);
}

std::string diagram_text(const BlockType& type, bool optional_inputs, const std::string& more,
                         int elements = 1) {
  Feeds feeds(elements);
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

std::vector<Wiring> wirings_of(const BlockType& type) {
  std::vector<Wiring> wirings{{diagram_text(type, false, "")}};
  add_choices(type, false, wirings);
  if (!has_optional_input(type)) return wirings;
  wirings.push_back({diagram_text(type, true, "")});
  add_choices(type, true, wirings);
  return wirings;
}

std::vector<Wiring> wide_wirings_of(const BlockType& type, int elements) {
  std::vector<Wiring> wirings{{diagram_text(type, false, "", elements), true}};
  if (has_optional_input(type)) wirings.push_back({diagram_text(type, true, "", elements), true});
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

Wiring located(const Wiring& wiring) {
  return {"events: locate\n" + wiring.text +
              "  swing: {block: Sine, amplitude: 1, frequency: 90 Hz}\n"
              "  crossing: {block: Compare, u: swing, operator: greater, to: 0.505}\n",
          wiring.may_be_refused};
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
