#include "engine/app/simulink/flat_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "engine/app/simulink/ambiguities.hpp"
#include "engine/app/simulink/matlab.hpp"
#include "engine/app/simulink/plain_text.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::simulink {

namespace {

constexpr int max_hops = 500, most_ports = 1000;
constexpr char token_start = '\x01', token_end = '\x02';

const std::string ground = "0";

std::string token(std::size_t block, int port) {
  return fmt::format("{}{}:{}{}", token_start, block, port, token_end);
}

/// Types of blocks that wires pass through, or that belong to their subsystem.
bool has_no_counterpart_of_its_own(const std::string& type) {
  static const std::set<std::string> types{"Inport",     "InportShadow", "Outport",
                                           "From",       "Goto",         "GotoTagVisibility",
                                           "EnablePort", "TriggerPort",  "ActionPort"};
  return types.contains(type);
}

}  // namespace

std::string text_of(const Model& model, const Block& block, const std::string& name,
                    const std::string& otherwise) {
  if (const auto own = block.texts.find(name); own != block.texts.end()) return own->second;
  if (const auto type = model.defaults.find(block.type); type != model.defaults.end())
    if (const auto found = type->second.find(name); found != type->second.end()) return found->second;
  return otherwise;
}

int port_number(const Model& model, const Block& block) {
  return std::max(1, std::atoi(text_of(model, block, "Port", "1").c_str()));
}

const Block* block_of_type(const System& system, std::string_view type) {
  const auto found = std::ranges::find(system.blocks, type, &Block::type);
  return found == system.blocks.end() ? nullptr : &*found;
}

bool is_conditional(const System& system) {
  return block_of_type(system, "EnablePort") || block_of_type(system, "TriggerPort") ||
         block_of_type(system, "ActionPort");
}

std::string obstacle_of(const Model& model, const Block& subsystem) {
  const std::string chart = text_of(model, subsystem, "SFBlockType", "NONE");
  if (chart != "NONE") return chart == "Chart" ? "a chart of Stateflow" : "a block of kind " + chart;
  if (!subsystem.system) return "a subsystem whose content is not in the file";
  if (text_of(model, subsystem, "Variant", "off") == "on") return "a subsystem with variants";
  constexpr const char* types[] = {"ForIterator", "WhileIterator", "ForEach", "ResetPort"};
  for (const char* type : types)
    if (block_of_type(*subsystem.system, type)) return fmt::format("a subsystem with {}", type);
  const Block* trigger = block_of_type(*subsystem.system, "TriggerPort");
  if (trigger && text_of(model, *trigger, "TriggerType", "rising") == "function-call")
    return "a subsystem that is called as a function";
  return "";
}

std::string Unit::take_name(const std::string& wanted) {
  std::string free = wanted;
  for (int& copy = copies[wanted]; !names.insert(free).second;)
    free = fmt::format("{}_{}", wanted, ++copy + 1);
  return free;
}

FlatModel::FlatModel(const Model& model, std::vector<Note>& notes)
    : model_(model), notes_(notes), workspace_(model, script_notes_) {
  for (const std::string& sentence : script_notes_) notes_.push_back({NoteKind::differs, "", sentence});
  units_.push_back(std::make_unique<Unit>());
  units_[0]->title = model.name;
  root_ = std::make_unique<Instance>();
  root_->system = &model.root;
  root_->unit = units_[0].get();
  units_[0]->instance = root_.get();
  build(*root_);
  note_equal_tags();
}

Instance* FlatModel::scope_of(const GotoBlock& block) const {
  const std::string visibility = text_of(model_, *block.second, "TagVisibility", "local");
  if (visibility == "global") return root_.get();
  if (visibility != "scoped") return block.first;
  const std::string tag = text_of(model_, *block.second, "GotoTag", "A");
  for (Instance* in = block.first; in; in = in->parent)
    for (const Block& one : in->system->blocks)
      if (one.type == "GotoTagVisibility" && text_of(model_, one, "GotoTag", "A") == tag) return in;
  return block.first;
}

/// True for a tag that is read in the systems of its scope as well.
static bool reaches_inner_systems(const Model& model, const Block& block) {
  return text_of(model, block, "TagVisibility", "local") != "local";
}

void FlatModel::note_equal_tags() {
  std::map<std::pair<std::string, const Instance*>, const GotoBlock*> first;
  for (const auto& [tag, block] : gotos_) {
    const auto [found, is_new] = first.emplace(std::pair(tag, scope_of(block)), &block);
    if (!is_new)
      notes_.push_back({NoteKind::fault, block.first->path + block.second->name,
                        fmt::format("sends the tag '{}', as '{}{}' does in the same scope; that one is read",
                                    tag, found->second->first->path, found->second->second->name)});
  }
}

void FlatModel::build(Instance& instance) {
  for (Note& note : ambiguities_of(model_, *instance.system, instance.path))
    notes_.push_back(std::move(note));
  for (const Block& block : instance.system->blocks) {
    instance.by_sid.try_emplace(block.sid, &block);
    instance.by_sid.try_emplace("name " + block.name, &block);
    if (block.type == "Outport") instance.outports.try_emplace(port_number(model_, block), &block);
    if (block.type == "Inport" && instance.prefix.empty()) name_input(instance, block);
  }
  add_lines(instance);
  for (const Block& block : instance.system->blocks) add_block(instance, block);
}

void FlatModel::name_input(Instance& instance, const Block& block) {
  Unit& unit = *instance.unit;
  const auto port = static_cast<std::size_t>(port_number(model_, block));
  if (port > instance.system->blocks.size()) return;
  if (unit.inputs.size() < port) unit.inputs.resize(port);
  if (unit.inputs[port - 1].empty()) unit.inputs[port - 1] = unit.take_name(valid_name(block.name));
}

void FlatModel::add_lines(Instance& instance) {
  for (const Line& line : instance.system->lines) {
    if (line.source.port.starts_with("out:")) {
      int& most = instance.outputs[line.source.sid];
      most = std::max(most, std::atoi(line.source.port.c_str() + 4));
    }
    if (!line.name.empty()) instance.line_names[line.source.sid + "#" + line.source.port] = line.name;
    for (const LineEnd& sink : line.sinks) {
      const auto found = instance.by_sid.find(sink.sid);
      const std::string& sid = found == instance.by_sid.end() ? sink.sid : found->second->sid;
      instance.sources[sid + "#" + sink.port] = line.source;
    }
  }
}

void FlatModel::add_block(Instance& instance, const Block& block) {
  const std::string commented = text_of(model_, block, "Commented", "off");
  if (commented == "on")
    return notes_.push_back({NoteKind::differs, instance.path + block.name, "is commented out and left out"});
  if (commented == "through") {
    if (!has_no_counterpart_of_its_own(block.type)) return pass_through(instance, block);
    notes_.push_back(
        {NoteKind::deviates, instance.path + block.name, "is commented through in Simulink, and acts here"});
  }
  if (block.type == "Goto")
    gotos_.emplace(text_of(model_, block, "GotoTag", "A"), std::pair(&instance, &block));
  if (has_no_counterpart_of_its_own(block.type)) return;
  const bool is_subsystem = block.type == "SubSystem" && obstacle_of(model_, block).empty();
  if (!is_subsystem || is_conditional(*block.system)) add_flat(instance, block);
  if (is_subsystem) add_child(instance, block);
}

/// Makes wires of a block that is commented through, from each input to the output of its number.
void FlatModel::pass_through(Instance& instance, const Block& block) {
  wires_.insert(&block);
  const int inputs = inputs_of(instance, block), outputs = outputs_of(instance, block);
  const std::string path = instance.path + block.name;
  if (inputs == outputs)
    return notes_.push_back({NoteKind::differs, path, "is commented through, and a wire here"});
  notes_.push_back({NoteKind::deviates, path,
                    fmt::format("is commented through and has {} and {}; an output is the input of its "
                                "number here, and 0 without one",
                                text::counted(inputs, "input"), text::counted(outputs, "output"))});
}

void FlatModel::add_flat(Instance& instance, const Block& block) {
  FlatBlock flat;
  flat.block = &block;
  flat.in = &instance;
  flat.path = instance.path + block.name;
  flat.name = instance.unit->take_name(instance.prefix + valid_name(block.name));
  instance.flat[&block] = blocks_.size();
  instance.unit->blocks.push_back(blocks_.size());
  blocks_.push_back(std::move(flat));
}

void FlatModel::add_child(Instance& instance, const Block& block) {
  auto child = std::make_unique<Instance>();
  child->system = block.system.get();
  child->owner = &block;
  child->parent = &instance;
  child->path = instance.path + block.name + "/";
  Instance& made = *child;
  instance.children[&block] = std::move(child);
  if (is_conditional(*block.system)) {
    open_unit(made);
  } else {
    made.unit = instance.unit;
    made.prefix = instance.unit->take_name(instance.prefix + valid_name(block.name)) + ".";
  }
  build(made);
}

void FlatModel::open_unit(Instance& child) {
  auto unit = std::make_unique<Unit>();
  unit->parent = child.parent->unit;
  unit->name = blocks_[child.parent->flat.at(child.owner)].name;
  unit->title = child.path.substr(0, child.path.size() - 1);
  unit->instance = &child;
  child.unit = unit.get();
  units_.push_back(std::move(unit));
}

std::string FlatModel::source(Instance& in, const Block& block, const std::string& port) {
  return follow_port(in, block, port, 0);
}

bool FlatModel::is_connected(const Instance& in, const Block& block, const std::string& port) const {
  return in.sources.contains(block.sid + "#" + port);
}

int FlatModel::inputs_of(const Instance& in, const Block& block) const {
  int count = std::atoi(text_of(model_, block, "PortCounts.in", "0").c_str());
  const std::string ports = text_of(model_, block, "Ports", "");
  if (count == 0 && !ports.empty() && !ports.starts_with("[]")) count = std::atoi(ports.c_str() + 1);
  for (int more = count + 1; more <= most_ports && is_connected(in, block, fmt::format("in:{}", more));
       ++more)
    count = more;
  return std::clamp(count, 0, most_ports);
}

int FlatModel::outputs_of(const Instance& in, const Block& block) const {
  const auto used = in.outputs.find(block.sid);
  const int least = used == in.outputs.end() ? 0 : std::min(used->second, most_ports);
  return std::max(least, written_outputs_of(block));
}

int FlatModel::written_outputs_of(const Block& block) const {
  const std::string given = text_of(model_, block, "PortCounts.out", "");
  if (!given.empty()) return std::clamp(std::atoi(given.c_str()), 0, most_ports);
  const std::string ports = text_of(model_, block, "Ports", "");
  const std::size_t comma = ports.find(',');
  return comma == ports.npos ? ports.starts_with("[") ? 0 : 1
                             : std::clamp(std::atoi(ports.c_str() + comma + 1), 0, most_ports);
}

std::string FlatModel::signal_name(const Instance& in, const Block& block, const std::string& port) const {
  const auto found = in.sources.find(block.sid + "#" + port);
  if (found == in.sources.end()) return "";
  const LineEnd& end = found->second;
  const auto line = in.line_names.find(end.sid + "#" + end.port);
  if (line != in.line_names.end()) return line->second;
  const auto from = in.by_sid.find(end.sid);
  if (from == in.by_sid.end() || !end.port.starts_with("out:")) return "";
  const auto name = from->second->output_names.find(std::atoi(end.port.c_str() + 4));
  if (name != from->second->output_names.end()) return name->second;
  return from->second->type == "Inport" ? from->second->name : "";
}

std::string FlatModel::follow_port(Instance& in, const Block& block, const std::string& port, int depth) {
  const auto found = in.sources.find(block.sid + "#" + port);
  return found == in.sources.end() ? ground : follow(in, found->second, depth + 1);
}

std::string FlatModel::no_source(const std::string& path, const std::string& what) {
  notes_.push_back({NoteKind::fault, path, what + "; what reads it gets 0, and an Outport is not recorded"});
  return ground;
}

std::string FlatModel::follow(Instance& in, const LineEnd& end, int depth) {
  if (depth > max_hops) return no_source(in.path, "has a loop of wires without any block in it");
  const auto found = in.by_sid.find(end.sid);
  if (found == in.by_sid.end())
    return no_source(in.path, fmt::format("has a line from a block '{}' that is not in the file", end.sid));
  const Block& block = *found->second;
  const int port = end.port.starts_with("out:") ? std::atoi(end.port.c_str() + 4) : 0;
  if (wires_.contains(&block)) return follow_port(in, block, fmt::format("in:{}", port), depth);
  if (const auto flat = in.flat.find(&block); flat != in.flat.end()) return token(flat->second, port);
  if (block.type == "Inport" || block.type == "InportShadow") return follow_inport(in, block, depth);
  if (block.type == "From") return follow_from(in, block, depth);
  const auto child = in.children.find(&block);
  if (child == in.children.end()) return no_source(in.path + block.name, "is read and has no signal here");
  const auto outport = child->second->outports.find(port);
  if (outport == child->second->outports.end()) return ground;
  return follow_port(*child->second, *outport->second, "in:1", depth);
}

std::string FlatModel::follow_inport(Instance& in, const Block& block, int depth) {
  const int port = port_number(model_, block);
  const bool is_top = !in.parent || in.unit != in.parent->unit;
  if (!is_top) return follow_port(*in.parent, *in.owner, fmt::format("in:{}", port), depth);
  const auto index = static_cast<std::size_t>(port - 1);
  return index < in.unit->inputs.size() ? in.unit->inputs[index] : ground;
}

std::string FlatModel::follow_from(Instance& in, const Block& block, int depth) {
  const std::string tag = text_of(model_, block, "GotoTag", "A");
  const auto [first, last] = gotos_.equal_range(tag);
  for (Instance* scope = &in; scope; scope = scope->parent)
    for (auto each = first; each != last; ++each)
      if (scope_of(each->second) == scope &&
          (scope == &in || reaches_inner_systems(model_, *each->second.second)))
        return through_units(*in.unit, *each->second.first, *each->second.second, depth);
  if (first != last) {
    const auto& [from, sender] = first->second;
    notes_.push_back(
        {NoteKind::deviates, in.path + block.name,
         fmt::format("reads the tag '{}', which '{}{}' does not send to this system in Simulink; "
                     "here it is read",
                     tag, from->path, sender->name)});
    return through_units(*in.unit, *from, *sender, depth);
  }
  return no_source(in.path + block.name, fmt::format("reads the tag '{}' that no Goto writes", tag));
}

std::string FlatModel::through_units(Unit& unit, Instance& goto_in, const Block& goto_block, int depth) {
  if (&unit == goto_in.unit) return follow_port(goto_in, goto_block, "in:1", depth);
  const std::string tag = text_of(model_, goto_block, "GotoTag", "A");
  if (!unit.parent) {
    notes_.push_back(
        {NoteKind::fault, goto_in.path + goto_block.name,
         fmt::format("sends the tag '{}' out of a subsystem that runs on condition; give that an output, 0 "
                     "is written there",
                     tag)});
    return ground;
  }
  const std::string outside = through_units(*unit.parent, goto_in, goto_block, depth + 1);
  for (const auto& [name, from] : unit.tags)
    if (from == outside) return name;
  const std::string name = unit.take_name(valid_name(tag));
  unit.tags[name] = outside;
  return name;
}

Value FlatModel::evaluate(Instance& in, const std::string& text) {
  evaluating_ = in.unit;
  return evaluated(
      text, [&](const std::string& name, bool is_function) { return variable(in, name, is_function); });
}

Value FlatModel::variable(Instance& in, const std::string& name, bool is_function) {
  for (Instance* at = &in; at->parent; at = at->parent) {
    if (!at->mask) read_mask(*at);
    if (const auto found = at->mask->find(name); found != at->mask->end()) return found->second;
  }
  if (is_function && !workspace_.has(name)) return Value::missing();
  for (Unit* unit = evaluating_; unit; unit = unit->parent) unit->variables.insert(name);
  return workspace_.find(name);
}

void FlatModel::read_mask(Instance& in) {
  in.mask.emplace();
  std::map<std::string, Value, std::less<>> values;
  const auto read = [&](const std::string& name, const std::string& text, bool inside) {
    try {
      Value value = evaluated(text, [&](const std::string& used, bool is_function) {
        const auto found = values.find(used);
        return inside && found != values.end() ? found->second : variable(*in.parent, used, is_function);
      });
      values[name] = std::move(value);
    } catch (const ValueError& error) {
      if (inside)
        notes_.push_back(
            {NoteKind::differs, in.path.substr(0, in.path.size() - 1),
             fmt::format("its mask sets {} = {}, which {}", name, on_one_line(text), error.what())});
    }
  };
  for (const auto& [name, text] : in.owner->mask)
    if (!text.empty()) read(name, text, false);
  std::vector<std::string> others;
  for (const auto& [name, text] : assignments_of(in.owner->mask_code, others)) read(name, text, true);
  for (const std::string& statement : others)
    notes_.push_back({NoteKind::differs, in.path.substr(0, in.path.size() - 1),
                      fmt::format("its mask has '{}', which is not executed", statement.substr(0, 80))});
  in.mask = std::move(values);
}

std::optional<std::pair<std::size_t, int>> FlatModel::token_of(const std::string& text) {
  if (text.size() < 5 || text[0] != token_start || text.find(token_end) != text.size() - 1)
    return std::nullopt;
  const std::size_t colon = text.find(':');
  std::pair<std::size_t, int> result{};
  std::from_chars(text.data() + 1, text.data() + colon, result.first);
  std::from_chars(text.data() + colon + 1, text.data() + text.size() - 1, result.second);
  return result;
}

std::string FlatModel::resolved(const std::string& text, int depth) const {
  if (text.find(token_start) == text.npos) return text;
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t start = std::min(text.find(token_start, at), text.size());
    result += text.substr(at, start - at);
    if (start == text.size()) break;
    const std::size_t end = text.find(token_end, start);
    const auto [index, port] = *token_of(text.substr(start, end - start + 1));
    const FlatBlock& block = blocks_[index];
    const auto output = block.outputs.find(port);
    const std::string inner = output == block.outputs.end() ? block.name : output->second;
    result += depth > max_hops ? ground : resolved(inner, depth + 1);
    at = end + 1;
  }
  return result;
}

}  // namespace stepwire::simulink
