// Keys `every`, `enable` and `trigger` of parts and blocks: creates the hidden blocks that activate them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/model/diagram/guard.hpp"
#include "engine/model/diagram/guard_keys.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/diagram/keys.hpp"
#include "engine/model/diagram/open.hpp"
#include "engine/model/diagram/resolve.hpp"

namespace stepwire::diagram {

namespace {

yaml::Node named(const std::string& text, const yaml::Mark& mark) {
  yaml::Node node;
  node.kind = yaml::Node::Kind::scalar;
  node.text = text;
  node.mark = mark;
  return node;
}

/// Returns a condition, in which names of blocks and inputs hide constants of the same name.
expression::Expression formula_of_condition(const Scope& scope, const std::string& text) {
  const yaml::Node* const blocks = scope.document->root.find("blocks");
  return expression::Expression::hiding_constants(text, [&](std::string_view name) {
    return (blocks && blocks->find(name)) || scope.inputs.contains(std::string(name));
  });
}

}  // namespace

int Opener::add_hidden(const Scope& scope, const std::string& name, const BlockType& type,
                       const yaml::Mark& mark) {
  Diagram& diagram = report_.diagram();
  const int index = static_cast<int>(diagram.blocks.size());
  DiagramBlock& block = diagram.blocks.emplace_back(scope.prefix + name, type);
  block.origin = scope.at(mark);
  make_room(block);
  block.guard = scope.guard;
  take_period_of_part(scope, block);
  return index;
}

void Opener::make_room(DiagramBlock& block) {
  const BlockType& type = block.type();
  block.inputs.resize(type.inputs.size());
  block.input_marks.resize(type.inputs.size());
  block.parameter_marks.resize(type.parameters.size());
  block.parameter_dimensions.resize(type.parameters.size());
}

void Opener::feed_hidden(int block, int input, int from, const Origin& origin) {
  Source source;
  source.block = from;
  source.output = 0;
  source.origin = origin;
  DiagramBlock& fed = report_.diagram().blocks[static_cast<std::size_t>(block)];
  fed.inputs[static_cast<std::size_t>(input)].push_back(std::move(source));
  fed.input_marks[static_cast<std::size_t>(input)] = origin.mark;
}

/// Connects a condition: a wire or a number to the guard itself, a formula through a block of its own.
void Opener::feed_guard(Scope& scope, const std::string& owner, const char* key, const yaml::Node& node,
                        int guard) {
  const int input = guard_type().input(key);
  const std::string subject = scope.prefix + owner + "." + key;
  if (!node.is_scalar())
    return report_.add(scope.at(node.mark), subject,
                       "is a signal or a formula of signals: 'door.angle > 5 deg'");
  if (!is_formula(node)) {
    report_.diagram().blocks[static_cast<std::size_t>(guard)].input_marks[static_cast<std::size_t>(input)] =
        node.mark;
    return pending_.push_back({guard, input, &node, &scope});
  }
  try {
    const int condition = add_condition(scope, owner + "." + key + "_when", node);
    feed_hidden(guard, input, condition, scope.at(node.mark));
  } catch (const expression::ExpressionError& error) {
    report_.add(scope.at(node.mark), subject,
                fmt::format("'{}', character {}: {}", node.text, error.position + 1, error.what()));
  }
}

int Opener::add_condition(Scope& scope, const std::string& name, const yaml::Node& node) {
  const std::string text = plain_formula(node.text);
  const auto formula = formula_of_condition(scope, text);
  const int index = add_hidden(scope, name, condition_type(), node.mark);
  yaml::Node& sources = made_.emplace_back();
  sources.kind = yaml::Node::Kind::list;
  sources.mark = node.mark;
  Value::List variables;
  for (const std::string& variable : formula.variables()) {
    if (variable == "time") continue;
    variables.push_back({variable, node.mark.line, node.mark.column});
    sources.items.push_back(source_of_variable(scope, variable, node.mark));
  }
  DiagramBlock& block = report_.diagram().blocks[static_cast<std::size_t>(index)];
  const auto set = [&](const char* parameter, Value value) {
    const ParameterSpec& spec = *condition_type().parameter(parameter);
    spec.set(block.block.get(), value);
    block.parameter_marks[static_cast<std::size_t>(&spec - condition_type().parameters.data())] = node.mark;
  };
  set("expression", {text, node.mark.line, node.mark.column});
  set("variables", {std::move(variables)});
  const int u = condition_type().input("u");
  block.input_marks[static_cast<std::size_t>(u)] = node.mark;
  if (!sources.items.empty()) pending_.push_back({index, u, &sources, &scope});
  return index;
}

/// Returns the source of a name in a condition: a parameter, or else a signal.
yaml::Node Opener::source_of_variable(const Scope& scope, const std::string& variable,
                                      const yaml::Mark& mark) {
  const bool is_parameter = scope.parameters.defined(variable);
  const yaml::Node* blocks = scope.document->root.find("blocks");
  if (is_parameter && ((blocks && blocks->find(variable)) || scope.inputs.contains(variable)))
    report_.add(scope.at(mark), scope.prefix + variable,
                "is a signal and a parameter; call one of them otherwise, so that a condition can name it");
  yaml::Node source = named((is_parameter ? "$" : "") + variable, mark);
  source.quoted = !is_parameter;
  return source;
}

Opener::Guarding Opener::open_guard(Scope& scope, const yaml::Entry& entry, const KeyTaken& is_own,
                                    const char* active) {
  Guarding made;
  const auto key = [&](const char* name) -> const yaml::Node* {
    const yaml::Node* node = entry.value.find(name);
    return node && is_own(name) && !is_condition(name, *node) ? nullptr : node;
  };
  const yaml::Node *enable = key("enable"), *trigger = key("trigger");
  if (!enable && !trigger) return made;
  made.guard = add_hidden(scope, entry.key + "." + active, guard_type(), (enable ? enable : trigger)->mark);
  for (const auto& [name, node] : {std::pair("enable", enable), std::pair("trigger", trigger)}) {
    if (!node) continue;
    GuardOptions options = read_guard_options(*node, name, scope, entry.key, report_);
    made.outputs = options.outputs ? options.outputs : made.outputs;
    made.edge = options.edge.value_or(made.edge);
    made.states = options.states.value_or(made.states);
    if (options.when) feed_guard(scope, entry.key, name, *options.when, made.guard);
  }
  Guard& guard =
      *static_cast<Guard*>(report_.diagram().blocks[static_cast<std::size_t>(made.guard)].block.get());
  guard.edge = static_cast<Guard::Edge>(made.edge);
  guard.states = static_cast<Guard::States>(made.states);
  scope.guarded[entry.key].guard = made.guard;
  return made;
}

int Opener::show_output(Scope& scope, const std::string& owner, const std::string& output,
                        const Guarding& guarding, const yaml::Mark& mark) {
  const int shown = add_hidden(scope, owner + "." + output + "_shown", guarded_output_type(), mark);
  feed_hidden(shown, guarded_output_type().input("active"), guarding.guard, scope.at(mark));
  scope.guarded[owner].outputs[output] = shown;
  return shown;
}

/// Adds the outputs for `outputs: reset` of a block.
void Opener::show_outputs(Scope& scope, const yaml::Entry& entry, const Guarding& guarding, int block) {
  if (!guarding.outputs) return;
  const BlockType& type = report_.diagram().blocks[static_cast<std::size_t>(block)].type();
  for (std::size_t o = 0; o < type.outputs.size(); ++o) {
    const int shown = show_output(scope, entry.key, type.outputs[o].name, guarding, entry.value.mark);
    feed_hidden(shown, guarded_output_type().input("u"), block, scope.at(entry.value.mark));
    DiagramBlock& made = report_.diagram().blocks[static_cast<std::size_t>(shown)];
    made.inputs[static_cast<std::size_t>(guarded_output_type().input("u"))].front().output =
        static_cast<int>(o);
    if (guarding.outputs->text != "reset") read_parameter(scope, scope.index, *guarding.outputs, made, 0);
  }
}

/// Adds those of a part, whose ports may have a `safe` value.
void Opener::show_outputs(Scope& scope, const yaml::Entry& entry, const Guarding& guarding, Scope& part) {
  if (!guarding.outputs) return;
  for (const auto& [name, out] : part.outputs) {
    if (!out.signal) continue;
    const int shown = show_output(scope, entry.key, name, guarding, entry.value.mark);
    const int u = guarded_output_type().input("u");
    DiagramBlock& made = report_.diagram().blocks[static_cast<std::size_t>(shown)];
    made.input_marks[static_cast<std::size_t>(u)] = out.signal->mark;
    pending_.push_back({shown, u, out.signal, &part});
    if (guarding.outputs->text != "reset")
      read_parameter(scope, scope.index, *guarding.outputs, made, 0);
    else if (out.safe)
      read_parameter(part, part.index, *out.safe, made, 0);
  }
}

void Opener::join_guards() {
  auto& blocks = report_.diagram().blocks;
  for (const auto& [block, node, scope] : within_) {
    DiagramBlock& guarded = blocks[static_cast<std::size_t>(block)];
    const auto found = scope->names.find(node->text);
    const int guard = found == scope->names.end() ? -1 : found->second.block;
    if (guard < 0 || &blocks[static_cast<std::size_t>(guard)].type() != &guard_type()) {
      report_.add(scope->at(node->mark), guarded.name + ".guard",
                  fmt::format("'{}' is no Guard", node->text));
      continue;
    }
    guarded.guard = guard;
    for (int above = guard; above >= 0; above = blocks[static_cast<std::size_t>(above)].guard)
      if (above == block) {
        report_.add(scope->at(node->mark), guarded.name + ".guard", "is its own guard");
        guarded.guard = -1;
        break;
      }
  }
}

}  // namespace stepwire::diagram
