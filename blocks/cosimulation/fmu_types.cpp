// Block types of FMUs: one for each file, with its own ports.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "blocks/cosimulation/fmu.hpp"
#include "blocks/cosimulation/fmu_types.hpp"
#include "engine/base/fmi/unit_error.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

using BindInput = void (*)(void*, const double*, Eigen::Index);
using UnbindInput = void (*)(void*);
using BindOutput = void (*)(void*, double*, Eigen::Index);

// A declaration binds ports by functions, so there is a function for each possible port.
/// Returns port k, which is created if needed.
template <class Port>
Port& port_at(std::vector<Port>& ports, std::size_t k) {
  if (ports.size() <= k) ports.resize(k + 1);
  return ports[k];
}

template <class Block, std::size_t k>
void bind_input(void* block, const double* data, Eigen::Index size) {
  port_at(static_cast<Block*>(block)->inputs, k).bind(data, size);
}

template <class Block, std::size_t k>
void unbind_input(void* block) {
  bind_input<Block, k>(block, nullptr, 0);
}

template <class Block, std::size_t k>
void bind_output(void* block, double* data, Eigen::Index size) {
  port_at(static_cast<Block*>(block)->results, k).bind(data, size);
}

template <class Block>
struct Binders {
  std::array<BindInput, Fmu::most_ports> input{};
  std::array<UnbindInput, Fmu::most_ports> none{};
  std::array<BindOutput, Fmu::most_ports> output{};

  template <std::size_t... k>
  explicit constexpr Binders(std::index_sequence<k...>)
      : input{bind_input<Block, k>...}, none{unbind_input<Block, k>...}, output{bind_output<Block, k>...} {}
};

using All = std::make_index_sequence<Fmu::most_ports>;

std::string doc_of(const fmi::Variable& variable) {
  return variable.description.empty() ? variable.name
                                      : fmt::format("{}: {}", variable.name, variable.description);
}

void require_few(const std::vector<const fmi::Variable*>& ports, const char* what) {
  if (ports.size() > Fmu::most_ports)
    throw fmi::UnitError(
        fmt::format("the unit has {} {}, and at most {} can be ports", ports.size(), what, Fmu::most_ports));
}

template <class Block>
void add_ports(BlockType& type, const fmi::Description& description) {
  static constexpr Binders<Block> bind{All()};
  const auto inputs = ports_of(description, fmi::Causality::input);
  const auto outputs = ports_of(description, fmi::Causality::output);
  require_few(inputs, "inputs");
  require_few(outputs, "outputs");
  const bool stepped = std::is_same_v<Block, SteppedFmu>;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    InputSpec spec{inputs[k]->port, inputs[k]->unit, std::to_string(inputs[k]->size), doc_of(*inputs[k]),
                   fmt::format("inputs[{}]", k)};
    spec.feedthrough = !stepped && description.feeds_through(*inputs[k]);
    spec.optional = true;
    spec.bind = bind.input[k];
    spec.unbind = bind.none[k];
    type.inputs.push_back(std::move(spec));
  }
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    type.outputs.push_back({outputs[k]->port, outputs[k]->unit, std::to_string(outputs[k]->size),
                            doc_of(*outputs[k]), fmt::format("results[{}]", k), "", bind.output[k]});
  }
}

/// Throws if a port has the name of a key of the block.
void refuse_taken_names(const BlockType& type) {
  std::set<std::string> taken{"block", "every", "enable", "trigger", "preset", "guard"};
  for (const ParameterSpec& parameter : type.parameters) taken.insert(parameter.name);
  for (const InputSpec& input : type.inputs)
    if (!taken.insert(input.name).second)
      throw fmi::UnitError(
          fmt::format("its input '{}' has the name of a key of the block; it cannot be wired", input.name));
}

template <class Block>
BlockType declared() {
  Declare<Block> is;
  Block::declare(is);
  BlockType type = is.take();
  type.folder = "cosimulation";
  type.header.clear();  // no code can be generated for foreign units
  return type;
}

void set_shape(BlockType& type, std::string_view state, std::size_t size) {
  const auto index = static_cast<std::size_t>(type.state(state));
  if (size == 0)
    type.states.erase(type.states.begin() + static_cast<std::ptrdiff_t>(index));
  else
    type.states[index].shape = std::to_string(size);
}

BlockType type_of(const fmi::Description& description, fmi::Mode mode) {
  const bool stepped = mode == fmi::Mode::co_simulation;
  BlockType type = stepped ? declared<SteppedFmu>() : declared<ContinuousFmu>();
  std::size_t shown = 0;
  for (const fmi::Variable* output : ports_of(description, fmi::Causality::output)) shown += output->size;
  if (stepped) {
    add_ports<SteppedFmu>(type, description);
    set_shape(type, "unit_outputs", shown);
    type.timing = Timing::discrete;
  } else {
    add_ports<ContinuousFmu>(type, description);
    set_shape(type, "unit_states", description.state_count);
    type.timing = Timing::continuous;
    type.at_events = true;  // even without states and indicators it has time events
    CrossingSpec crossing{"an event of the unit", std::to_string(description.indicator_count), {}};
    for (const InputSpec& input : type.inputs) crossing.inputs.push_back(input.name);
    type.crossings.push_back(std::move(crossing));
  }
  refuse_taken_names(type);
  return type;
}

/// Returns the interface with this name, or the one that the unit has.
fmi::Mode mode_of(const fmi::Description& description, const std::string& word) {
  const bool steps = !description.co_simulation.identifier.empty();
  const bool exchanges = !description.model_exchange.identifier.empty();
  if (word == "co_simulation" && !steps)
    throw fmi::UnitError("the unit has no co-simulation; its interface is model_exchange");
  if (word == "model_exchange" && !exchanges)
    throw fmi::UnitError("the unit has no model exchange; its interface is co_simulation");
  return word == "model_exchange" || !steps ? fmi::Mode::model_exchange : fmi::Mode::co_simulation;
}

}  // namespace

BlockType any_fmu_type() {
  return declared<SteppedFmu>();
}

const BlockType& fmu_type(const std::string& file, const std::string& word) {
  using Known = std::pair<std::shared_ptr<const fmi::Package>, std::string>;
  static std::mutex mutex;
  // The packages stay open, so that their addresses, which are keys here, are not reused.
  static std::map<Known, std::unique_ptr<const BlockType>> known;
  const auto package = fmi::open_package(file);
  const std::lock_guard lock(mutex);
  auto& type = known[{package, word}];
  if (!type) {
    const fmi::Description& description = package->description();
    type = std::make_unique<const BlockType>(type_of(description, mode_of(description, word)));
  }
  return *type;
}

}  // namespace stepwire
