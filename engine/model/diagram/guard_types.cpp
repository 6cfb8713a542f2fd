#include "engine/model/diagram/guard_types.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/expression/expression_function.hpp"
#include "engine/base/expression/margin.hpp"
#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"
#include "engine/model/diagram/condition.hpp"
#include "engine/model/diagram/guard.hpp"

namespace stepwire::diagram {

namespace {

template <class Block>
BlockType declared(const char* header) {
  Declare<Block> is;
  Block::declare(is);
  BlockType type = is.take();
  type.header = header;
  return type;
}

}  // namespace

void Guard::declare(Declare<Guard>& is) {
  is.block("Guard", {.doc = "Decides at every tick whether the blocks that name it in `within` are active.",
                     .timing = Timing::discrete});
  is.parameter<&Guard::edge>(
      {.doc = "which crossings of 0 the trigger counts", .words = {"rising", "falling", "either"}});
  is.parameter<&Guard::states>({.doc = "of what becomes active: go on where they stood, or begin anew",
                                .words = {"held", "reset"},
                                .structural = true});
  is.input<&Guard::enable>({.unit = "*", .doc = "active while above 0", .optional = true});
  is.input<&Guard::trigger>({.unit = "*", .doc = "active where this crosses 0", .optional = true});
  is.output<&Guard::active>({.doc = "1 or 0"});
  is.crossing<&Guard::enable>("enable passes 0", "1");
  is.crossing<&Guard::trigger>("trigger passes 0", "1");
  is.state<&Guard::seen>({.doc = "was there a tick before?", .settable = false});
  is.state<&Guard::high>({.doc = "was the trigger above 0 at that tick?", .settable = false});
}

void Condition::configure(Configure& is) {
  const Index inputs = is.count<&Condition::u>();
  if (inputs > max_inputs || static_cast<Index>(variables.size()) != inputs)
    is.refuse<&Condition::variables>(fmt::format("{} for {}; each needs one, and {} are the most",
                                                 text::there_are(variables.size(), "name"),
                                                 text::counted(inputs, "input"), max_inputs));
  try {
    const auto is_variable = [&](std::string_view name) { return std::ranges::count(variables, name) > 0; };
    auto read = expression::Expression::hiding_constants(expression.view(), is_variable);
    std::vector<std::size_t> places;
    for (const std::string& name : read.variables()) {
      const auto found = std::ranges::find(variables, name);
      if (found == variables.end() && name != "time")
        is.refuse<&Condition::expression>(fmt::format("'{}' is none of its variables", name));
      places.push_back(static_cast<std::size_t>(found - variables.begin()));
    }
    margin = expression::function_of(expression::margin_of(read), places);
    formula = expression::function_of(std::move(read), std::move(places));
  } catch (const expression::ExpressionError& error) {
    is.refuse<&Condition::expression>(
        fmt::format("'{}', character {}: {}", expression.view(), error.position + 1, error.what()));
  }
}

void Condition::declare(Declare<Condition>& is) {
  is.block("Condition", {.doc = "A formula over single numbers and the time.", .steady = true});
  is.parameter<&Condition::expression>({.doc = "above 0, or true, where the condition holds"});
  is.parameter<&Condition::variables>({.doc = "names of the inputs in the formula, in their order"});
  is.input<&Condition::u>({.unit = "*", .shape = "1", .doc = "what the formula reads", .optional = true});
  is.output<&Condition::y>({.unit = "*", .doc = "the value"});
  is.clock<&Condition::time>();
  is.crossing<&Condition::u>("the formula becomes or ceases to be above 0, or true", "1");
  is.derived<&Condition::formula>();
  is.derived<&Condition::margin>();
}

void GuardedOutput::declare(Declare<GuardedOutput>& is) {
  is.block("GuardedOutput", {.doc = "An output that has a value of its own while it is off."});
  is.parameter<&GuardedOutput::off>({.unit = "'u", .doc = "value while off"});
  is.input<&GuardedOutput::u>({.unit = "'u", .doc = "the output"});
  is.input<&GuardedOutput::active>({.doc = "of the guard"});
  is.output<&GuardedOutput::y>({.unit = "'u", .doc = "what others read"});
}

void ParameterValue::declare(Declare<ParameterValue>& is) {
  is.block("ParameterValue", {.doc = "A parameter that is recorded."});
  is.parameter<&ParameterValue::value>({.unit = "'u", .doc = "its value"});
  is.output<&ParameterValue::y>({.unit = "'u", .doc = "the same"});
}

const BlockType& guard_type() {
  static const BlockType type = declared<Guard>("engine/model/diagram/guard.hpp");
  return type;
}

const BlockType& condition_type() {
  static const BlockType type = declared<Condition>("engine/model/diagram/condition.hpp");
  return type;
}

const BlockType& guarded_output_type() {
  static const BlockType type = declared<GuardedOutput>("engine/model/diagram/guard.hpp");
  return type;
}

const BlockType& parameter_value_type() {
  static const BlockType type = declared<ParameterValue>("engine/model/diagram/guard.hpp");
  return type;
}

const std::vector<const BlockType*>& guard_types() {
  static const std::vector<const BlockType*> types{&guard_type(), &condition_type(), &guarded_output_type(),
                                                   &parameter_value_type()};
  return types;
}

const BlockType* find_guard_type(std::string_view name) {
  for (const BlockType* type : guard_types())
    if (type->name == name) return type;
  return nullptr;
}

}  // namespace stepwire::diagram
