#include "engine/analyse/linear/prepared_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace stepwire::linear {
namespace {

using Neighbours = std::vector<std::vector<std::size_t>>;

std::vector<char> reached(const Neighbours& neighbours, const std::vector<int>& starts) {
  std::vector<char> found(neighbours.size(), 0);
  std::vector<std::size_t> queue(starts.begin(), starts.end());
  while (!queue.empty()) {
    const std::size_t block = queue.back();
    queue.pop_back();
    if (std::exchange(found[block], 1)) continue;
    queue.insert(queue.end(), neighbours[block].begin(), neighbours[block].end());
  }
  return found;
}

/// True for a block with a rate of its own. A block that follows its inputs' rate does not sample by itself.
bool samples(const diagram::DiagramBlock& block) {
  return !block.inputs.empty() && (block.every || block.type().timing == Timing::discrete);
}

/// Inserts a junction between an output of a block and all its readers. Returns the index of the new block. A
/// run with idle junctions has the same bits as one without.
int add_junction(diagram::Diagram& diagram, const diagram::SignalRef& output) {
  const int index = static_cast<int>(diagram.blocks.size());
  for (diagram::DiagramBlock& block : diagram.blocks)
    for (auto& sources : block.inputs)
      for (diagram::Source& source : sources)
        if (source.block == output.block && source.output == output.output) {
          source.block = index;
          source.output = 0;
        }
  const diagram::Origin origin = diagram.blocks[static_cast<std::size_t>(output.block)].origin;
  diagram::DiagramBlock junction(fmt::format("junction {}", index), junction_type());
  junction.origin = origin;
  diagram::Source source;
  source.block = output.block;
  source.output = output.output;
  source.origin = origin;
  junction.inputs = {{source}};
  junction.input_marks.resize(1);
  diagram.blocks.push_back(std::move(junction));
  return index;
}

/// Inserts junctions into wires, at most one into each.
class Junctions {
 public:
  explicit Junctions(diagram::Diagram& diagram) : diagram_(diagram) {}

  int at(const diagram::SignalRef& wire) {
    if (const int known = find(wire); known >= 0) return known;
    made_.emplace_back(wire, add_junction(diagram_, wire));
    return made_.back().second;
  }

  /// Returns the index of a wire's junction; -1 if it has none.
  int find(const diagram::SignalRef& wire) const {
    const auto found = std::ranges::find(made_, wire, &std::pair<diagram::SignalRef, int>::first);
    return found == made_.end() ? -1 : found->second;
  }

  std::vector<int> blocks() const {
    std::vector<int> all;
    for (const auto& [wire, block] : made_) all.push_back(block);
    return all;
  }

 private:
  diagram::Diagram& diagram_;
  std::vector<std::pair<diagram::SignalRef, int>> made_;
};

/// A signal, and the block of the plan at which it is read or perturbed.
struct Met {
  Signal signal;
  int block = -1;
};

void add_places(const plan::Plan& plan, const Met& met, const plan::SignalSlot& slot, yaml::Fault at,
                std::vector<Place>& places, yaml::Faults& faults) {
  const std::string unit = unit_of(plan, met.signal.signal);
  if (slot.size == 0) {
    at.message = yaml::fault_text("'{}' has no elements", met.signal.name);
    return faults.add(std::move(at));
  }
  if (met.signal.element && *met.signal.element >= slot.size) {
    at.message = yaml::fault_text("'{}' has {} elements", met.signal.name, slot.size);
    return faults.add(std::move(at));
  }
  for (Eigen::Index k = 0; k < slot.size; ++k) {
    if (met.signal.element && *met.signal.element != k) continue;
    const bool numbered = slot.size > 1 && !met.signal.element;
    places.push_back({slot.offset + static_cast<std::size_t>(k),
                      {numbered ? fmt::format("{}.{}", met.signal.name, k + 1) : met.signal.name, unit}});
  }
}

bool same_place(const std::vector<Met>& a, const std::vector<Met>& b) {
  return a.size() == 1 && b.size() == 1 && a[0].signal.signal == b[0].signal.signal;
}

/// Signals of a request.
struct Touched {
  std::vector<Met> from, to;
  std::vector<diagram::SignalRef> cut;
};

Touched find_touched(const diagram::Diagram& diagram, const Request& request) {
  yaml::Faults faults;
  Touched touched;
  for (const WrittenName& name : request.from)
    if (auto found = find_wire(diagram, name, faults)) touched.from.push_back({*found});
  for (const WrittenName& name : request.open)
    if (const auto found = find_wire(diagram, name, faults)) touched.cut.push_back(found->signal);
  for (const WrittenName& name : request.to)
    if (auto found = find_signal(diagram, name, faults)) {
      // A state that is an output is read as the wire.
      yaml::Faults none;
      if (const auto wire = find_wire(diagram, name, none)) found = wire;
      touched.to.push_back({*found});
    }
  faults.throw_if_any();
  return touched;
}

void put_junctions(diagram::Diagram& diagram, Touched& touched, PreparedDiagram& prepared) {
  Junctions junctions(diagram);
  for (Met& met : touched.from) met.block = junctions.at(met.signal.signal);
  for (const diagram::SignalRef& wire : touched.cut) prepared.cut.push_back(junctions.at(wire));
  for (Met& met : touched.to) {
    const int junction = junctions.find(met.signal.signal);
    const bool behind = junction >= 0 && std::ranges::count(prepared.cut, junction) == 0;
    met.block = behind ? junction : met.signal.signal.block;
  }
  prepared.junctions = junctions.blocks();
  if (same_place(touched.from, touched.to) &&
      std::ranges::count(touched.cut, touched.from[0].signal.signal) > 0)
    prepared.feedback = 1.0;
}

void add_input(const Met& met, const WrittenName& name, PreparedDiagram& prepared, yaml::Faults& faults) {
  const auto& block = prepared.plan.blocks[static_cast<std::size_t>(met.block)];
  const plan::SignalSlot &added = block.states[Junction::added_state], &wire = block.inputs[0][0];
  const std::size_t first = prepared.inputs.size();
  add_places(prepared.plan, met, added, {name.place, name.subject, {}, {}}, prepared.inputs, faults);
  for (std::size_t i = first; i < prepared.inputs.size(); ++i)
    prepared.inputs[i].wire = wire.offset + (prepared.inputs[i].offset - added.offset);
  prepared.input_blocks.push_back(met.block);
}

void add_output(const Met& met, const WrittenName& name, PreparedDiagram& prepared, yaml::Faults& faults) {
  const bool behind = met.block != met.signal.signal.block;
  const diagram::SignalRef read = behind ? diagram::SignalRef{met.block, 0, -1} : met.signal.signal;
  add_places(prepared.plan, met, prepared.plan.slot(read), {name.place, name.subject, {}, {}},
             prepared.outputs, faults);
  prepared.output_blocks.push_back(met.block);
}

bool delays_time(const diagram::DiagramBlock& block) {
  return !block.type().delayed_by.empty();
}

/// Returns the delay blocks to remove. Empty if another block between inputs and outputs acts at ticks only.
std::vector<int> delays_to_take(const diagram::Diagram& diagram, const Touched& touched,
                                const PreparedDiagram& prepared, const Request& request) {
  if (request.whole || std::ranges::none_of(diagram.blocks, delays_time)) return {};
  const plan::Plan plan = plan::make_plan(diagram);
  std::vector<int> from, to, found;
  for (const Met& met : touched.from) from.push_back(met.block);
  for (const Met& met : touched.to) to.push_back(met.block);
  const Paths paths = find_paths(plan, from, to, prepared.cut);
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const bool is_delay = delays_time(plan.diagram.blocks[b]);
    if (!is_delay && paths.on_way(b) && paths.samples[b]) return {};
    if (is_delay && paths.near_way(b)) found.push_back(static_cast<int>(b));
  }
  return found;
}

int source_of(const diagram::DiagramBlock& block, const std::string& input) {
  const auto& sources = block.inputs[static_cast<std::size_t>(block.type().input(input))];
  return sources.empty() ? -1 : sources.front().block;
}

/// Adds the places of a delay: an input after its output, and an output at its source.
void take_delay(int block, int junction, PreparedDiagram& prepared) {
  const plan::Plan& plan = prepared.plan;
  const auto index = static_cast<std::size_t>(block), cut = static_cast<std::size_t>(junction);
  const diagram::DiagramBlock& delay = plan.diagram.blocks[index];
  const plan::SignalSlot &added = plan.blocks[cut].states[Junction::added_state],
                         &wire = plan.blocks[cut].inputs[0][0], &fed = plan.blocks[index].inputs[0][0];
  const BlockType& type = delay.type();
  const std::string unit = unit_of(plan, {block, 0, -1});
  for (std::size_t k = 0; k < static_cast<std::size_t>(fed.size); ++k) {
    const std::string element = fed.size > 1 ? fmt::format(".{}", k + 1) : "";
    prepared.inputs.push_back(
        {added.offset + k, {delay.name + "." + type.outputs[0].name + element, unit}, wire.offset + k});
    prepared.outputs.push_back({fed.offset + k, {delay.name + "." + type.inputs[0].name + element, unit}, 0});
    const plan::SignalSlot& length =
        plan.blocks[index].inputs[static_cast<std::size_t>(type.input(type.delayed_by))][0];
    prepared.delays.push_back({length.offset, plan.diagram.step, source_of(delay, type.delayed_by)});
  }
  prepared.input_blocks.push_back(junction);
  if (const int source = source_of(delay, type.inputs[0].name); source >= 0)
    prepared.output_blocks.push_back(source);
}

}  // namespace

void Junction::declare(Declare<Junction>& is) {
  is.block("Junction", {.doc = "A place in a wire at which a signal is cut, or something is added to it."});
  is.input<&Junction::u>({.unit = "'u", .doc = "the signal"});
  is.output<&Junction::y>({.unit = "'u", .doc = "the signal as all read it"});
  is.state<&Junction::added>({.unit = "'u", .doc = "what is added", .settable = false});
  is.state<&Junction::held>({.unit = "'u", .doc = "what stands there once it is cut", .settable = false});
  is.state<&Junction::cut>({.doc = "1 once it is cut", .settable = false});
}

const BlockType& junction_type() {
  static const BlockType type = [] {
    Declare<Junction> is;
    Junction::declare(is);
    BlockType made = is.take();
    made.timing = Timing::inherited;  // also evaluated between ticks, with its signal
    return made;
  }();
  return type;
}

bool Paths::sampled() const {
  for (std::size_t b = 0; b < samples.size(); ++b)
    if (samples[b] && on_way(b)) return true;
  return false;
}

Paths find_paths(const plan::Plan& plan, const std::vector<int>& inputs, const std::vector<int>& outputs,
                 const std::vector<int>& cut) {
  const auto& blocks = plan.diagram.blocks;
  Neighbours readers(blocks.size()), sources(blocks.size());
  Paths paths;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    paths.samples.push_back(samples(blocks[b]));
    if (std::ranges::count(cut, static_cast<int>(b)) > 0) continue;
    for (const auto& list : blocks[b].inputs)
      for (const diagram::Source& source : list) {
        if (source.block < 0) continue;
        readers[static_cast<std::size_t>(source.block)].push_back(b);
        sources[b].push_back(static_cast<std::size_t>(source.block));
      }
  }
  paths.from_inputs = reached(readers, inputs);
  paths.to_outputs = reached(sources, outputs);
  return paths;
}

std::int64_t base_period(const plan::Plan& plan, const Paths& paths) {
  std::int64_t period = 1;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b)
    if (paths.samples[b] && paths.on_way(b)) period = std::lcm(period, plan.blocks[b].rate.ticks);
  return period;
}

std::string unit_of(const plan::Plan& plan, const diagram::SignalRef& signal) {
  const auto dimension = plan.dimension(signal);
  return !dimension || *dimension == unit::Dimension{} ? std::string{} : unit::si_name(*dimension);
}

PreparedDiagram prepare(diagram::Diagram diagram, const Request& request) {
  Touched touched = find_touched(diagram, request);
  PreparedDiagram prepared;
  put_junctions(diagram, touched, prepared);
  const std::vector<int> delays = delays_to_take(diagram, touched, prepared, request);
  Junctions junctions(diagram);
  for (const int block : delays) {
    prepared.cut.push_back(junctions.at({block, 0, -1}));
    for (Met& met : touched.to)
      if (met.block == block) met.block = prepared.cut.back();
  }
  diagram::Diagram stepped = diagram;
  stepped.events.locate = false;  // both sides of a bend or jump are seen, in place of the present mode
  prepared.plan = plan::make_plan(std::move(diagram));
  prepared.slopes = plan::make_plan(std::move(stepped));
  yaml::Faults faults;
  for (std::size_t i = 0; i < touched.from.size(); ++i)
    add_input(touched.from[i], request.from[i], prepared, faults);
  for (std::size_t i = 0; i < touched.to.size(); ++i)
    add_output(touched.to[i], request.to[i], prepared, faults);
  faults.throw_if_any();
  for (std::size_t i = 0; i < delays.size(); ++i) take_delay(delays[i], junctions.blocks()[i], prepared);
  return prepared;
}

}  // namespace stepwire::linear
