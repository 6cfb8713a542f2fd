#include "engine/app/studio/live/pointer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/base/io/resources.hpp"
#include "engine/model/diagram/named_signals.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/view/scene/scene_pointer.hpp"

namespace stepwire::live {
namespace {

/// Part of the model that represents the hand; it follows the pointer.
constexpr const char* pointer_part = "pointer_hand";

using scene::ScenePointer;
using Names = std::map<std::string, diagram::SignalRef>;

/// Lookup of the signals that a pointer names.
class Signals {
 public:
  Signals(const diagram::Diagram& diagram, const yaml::Mark& mark)
      : diagram_(diagram), mark_(mark), names_(diagram::named_signals(diagram)) {}

  /// Returns an output of a block. Throws Error with the nearest name.
  diagram::SignalRef find(const std::string& name) const {
    const auto found = names_.find(name);
    if (found == names_.end()) refuse(fmt::format("there is no signal '{}'", name) + nearest(name));
    if (found->second.output < 0) refuse(fmt::format("'{}' is a state; name an output of a block", name));
    return found->second;
  }

  [[noreturn]] void refuse(const yaml::Message& message) const {
    throw yaml::Error(yaml::Fault{{diagram_.file, mark_}, "scene.pointer", message, {}});
  }

 private:
  yaml::Message nearest(const std::string& name) const {
    std::vector<std::string> all;
    for (const auto& [known, signal] : names_) all.push_back(known);
    return yaml::did_you_mean(name, all);
  }

  const diagram::Diagram& diagram_;
  yaml::Mark mark_;
  Names names_;
};

std::optional<ScenePointer> pointer_of(const diagram::Diagram& diagram) {
  const yaml::Node* node = diagram.scene.find("pointer");
  if (!node) return std::nullopt;
  yaml::Faults faults;
  const query::SymbolTable names{diagram.file, {}};
  const auto pointer = scene::read_scene_pointer(*node, {"scene.pointer", names, faults});
  faults.throw_if_any();
  return pointer;
}

yaml::Node& under(yaml::Node& map, const std::string& key, const yaml::Mark& mark) {
  const auto found = std::ranges::find(map.entries, key, &yaml::Entry::key);
  if (found != map.entries.end()) return found->value;
  yaml::Node empty;
  empty.kind = yaml::Node::Kind::map;
  empty.mark = mark;
  map.entries.push_back({key, mark, std::move(empty)});
  return map.entries.back().value;
}

void mark_all(yaml::Node& node, const yaml::Mark& mark) {
  node.mark = mark;
  for (yaml::Node& item : node.items) mark_all(item, mark);
  for (yaml::Entry& entry : node.entries) {
    entry.mark = mark;
    mark_all(entry.value, mark);
  }
}

/// Adds an entry to a section of the file. Its mark is that of `pointer`, so that faults refer to it.
void add_entry(yaml::Node& root, const std::string& section, const std::string& name, const std::string& text,
               const yaml::Mark& mark) {
  yaml::Node value = yaml::parse_document(text, "pointer").root;
  mark_all(value, mark);
  under(root, section, mark).entries.push_back({name, mark, std::move(value)});
}

/// Returns the start position of the pin in the file's own run, as YAML.
std::string start_of(const plan::Plan& plan, const diagram::SignalRef& position) {
  run::Executor start(plan);
  start.evaluate();
  const double* at = start.values() + plan.slot(position).offset;
  return fmt::format("x: {} m, y: {} m", at[0], at[1]);
}

/// Returns the YAML of the block of the hand.
std::string hand_text(const ScenePointer& pointer, const plan::Plan& plan, const Signals& signals) {
  const std::string parts = io::resource("diagrams") + "/parts/";
  const std::string led = fmt::format("pointer: {}, held: {}", pointer_input, held_input);
  if (!pointer.force.empty())
    return fmt::format("{{diagram: \"{}pointer-hand.yaml\", {}, position: {}, velocity: {}}}", parts, led,
                       pointer.position, pointer.velocity);
  return fmt::format("{{diagram: \"{}pointer-push.yaml\", {}, load: {}, {}}}", parts, led, pointer.load,
                     start_of(plan, signals.find(pointer.motion[0])));
}

/// Returns pairs of a signal of the file and the signal that replaces it.
std::vector<std::pair<std::string, std::string>> replaced_by(const ScenePointer& pointer) {
  const std::string hand = std::string(pointer_part) + ".";
  if (!pointer.place.empty()) return {{pointer.place, pointer_input}};
  if (!pointer.force.empty()) return {{pointer.force, hand + "force"}};
  return {{pointer.motion[0], hand + "position"},
          {pointer.motion[1], hand + "velocity"},
          {pointer.motion[2], hand + "acceleration"}};
}

/// Replaces one signal by another at all readers except the blocks of the hand.
void redirect(diagram::Diagram& diagram, const diagram::SignalRef& from, const diagram::SignalRef& to) {
  const std::string own = std::string(pointer_part) + ".";
  const auto turn = [&](auto& signal) {
    if (signal.block == from.block && signal.output == from.output)
      signal.block = to.block, signal.output = to.output;
  };
  for (diagram::DiagramBlock& block : diagram.blocks)
    if (!block.name.starts_with(own))
      for (std::vector<diagram::Source>& sources : block.inputs)
        for (diagram::Source& source : sources) turn(source);
  for (diagram::DiagramOutput& output : diagram.outputs) turn(output.signal);
  for (diagram::RecordRequest& request : diagram.records)
    for (diagram::RecordedSignal& signal : request.signals) turn(signal.signal);
}

/// Returns the plan in which the hand replaces the signals that the file names.
plan::Plan led_plan(diagram::Diagram diagram, const ScenePointer& pointer) {
  const Signals signals(diagram, pointer.mark);
  const auto unit_of = [&](const diagram::SignalRef& signal) {
    return diagram
        .output_dimensions[static_cast<std::size_t>(signal.block)][static_cast<std::size_t>(signal.output)];
  };
  for (const auto& [from, to] : replaced_by(pointer)) {
    const diagram::SignalRef before = signals.find(from);
    const auto unit = unit_of(before), led = unit_of(signals.find(to));
    if (unit && led && *unit != *led)
      signals.refuse(fmt::format("'{}' is in {}, and a pointer gives {}", from, unit::si_name(*unit),
                                 unit::si_name(*led)));
    redirect(diagram, before, signals.find(to));
  }
  return plan::make_plan(std::move(diagram));
}

}  // namespace

bool offers_pointer(const diagram::Diagram& diagram) {
  return diagram.scene.find("pointer") != nullptr;
}

bool has_pointer(const diagram::Diagram& diagram) {
  return std::ranges::find(diagram.inputs, std::string(pointer_input), &diagram::DiagramInput::name) !=
         diagram.inputs.end();
}

session::LoadedModel load_for_page(diagram::Loader& loader, const std::string& file,
                                   const session::LoadOptions& options) {
  session::LoadedModel model = session::load_model(loader, file, options);
  const auto pointer = pointer_of(model.job.plan.diagram);
  if (!pointer) return model;
  const Signals signals(model.job.plan.diagram, pointer->mark);
  for (const auto& [from, to] : replaced_by(*pointer)) signals.find(from);
  yaml::Document document = loader.document(file);
  const auto add = [&](const char* section, const char* name, const std::string& text) {
    add_entry(document.root, section, name, text, pointer->mark);
  };
  add("inputs", pointer_input, "{unit: m, default: [0 m, 0 m], doc: \"pointer of the page, [x, y]\"}");
  add("inputs", held_input, "{default: 0, doc: 1 while the pointer holds the pin}");
  if (pointer->place.empty()) add("blocks", pointer_part, hand_text(*pointer, model.job.plan, signals));
  loader.add(std::move(document));
  model = session::load_model(loader, file, options);
  model.job.plan = led_plan(model.job.plan.diagram, *pointer);
  return model;
}

}  // namespace stepwire::live
