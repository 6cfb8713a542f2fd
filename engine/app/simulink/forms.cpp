#include "engine/app/simulink/forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace stepwire::simulink {

yaml::Node block_node(const std::string& type, std::vector<std::pair<std::string, yaml::Node>> keys) {
  yaml::Node node = map_of({{"block", word(type)}});
  for (auto& [key, value] : keys) add(node, std::move(key), std::move(value));
  return node;
}

BlockWriter& expression(BlockWriter& write, const std::string& formula, std::vector<yaml::Node> inputs) {
  write.make("Expression");
  write.key("u", inputs.size() == 1 ? inputs[0] : list_of(std::move(inputs)));
  return write.key("expression", formula);
}

yaml::Node constant_source(BlockWriter& write, const std::string& suffix, const Value& value) {
  if (value.is_scalar()) return cell_node(value.cells[0]);
  return word(write.extra(suffix, block_node("Constant", {{"value", list_node(value)}})));
}

std::string in_formula(const Cell& cell) {
  const std::string text = cell.formula();
  return cell.strength < 9 || text.starts_with("-") ? "(" + text + ")" : text;
}

Value divided(const Value& value, double by) {
  return each('/', value, Value::of(by));
}

/// Adds the block that is true where a level of Simulink resets: the signal is not 0 now, or was not at the
/// sample before. Returns its name.
static std::string level_condition(BlockWriter& write, const std::string& signal) {
  if (write.block().type != "DiscreteIntegrator")  // the state is held up to the step at which it is free
    return write.extra("reset",
                       block_node("Expression", {{"u", word(signal)}, {"expression", word("u1 != 0")}}));
  yaml::Node before = block_node("UnitDelay", {{"u", word(signal)}, {"initial", word("0")}});
  const SampleTime time = write.sample_time("SampleTime", "1");
  if (time.kind == SampleTime::Kind::discrete) add(before, "every", write.every_node(time));
  const std::string last = write.extra("reset_before", std::move(before));
  return write.extra("reset", block_node("Expression", {{"u", list_of({word(signal), word(last)})},
                                                        {"expression", word("u1 != 0 || u2 != 0")}}));
}

void add_reset(BlockWriter& write, const std::string& kind, int input) {
  if (kind == "none") return;
  static const std::set<std::string> known{"rising", "falling", "either", "level"};
  if (!known.contains(kind)) throw Untranslated("its external reset is '" + kind + "'");
  const std::string signal = write.source(input);
  write.key("reset", kind == "level" ? level_condition(write, signal) : signal).key("trigger", kind);
}

int initial_input(const Model& model, const Block& integrator) {
  if (text_of(model, integrator, "InitialConditionSource", "internal") != "external") return 0;
  return text_of(model, integrator, "ExternalReset", "none") == "none" ? 2 : 3;
}

/// Adds an initial value from outside. Behind a block IC it is the value of that at the first step, and at a
/// reset the input of that.
static void add_initial_signal(BlockWriter& write, const std::string& source, bool has_reset) {
  FlatModel& model = write.model();
  const auto at = FlatModel::token_of(source);
  const FlatBlock* from = at ? &model.blocks()[at->first] : nullptr;
  if (!from || from->block->type != "InitialCondition" || from->in->unit != write.instance().unit) {
    write.key("initial", source);
    return;
  }
  const Value value = model.evaluate(*from->in, text_of(model.model(), *from->block, "Value", "1"));
  write.key("initial", write.extra("initial", block_node("Constant", {{"value", value_node(value)}})));
  if (has_reset) write.key("value", model.source(*from->in, *from->block, "in:1"));
}

void add_integrator_keys(BlockWriter& write) {
  const std::string reset = write.text("ExternalReset", "none");
  add_reset(write, reset, 2);
  if (const int input = initial_input(write.model().model(), write.block()); input > 0)
    add_initial_signal(write, write.source(input), reset != "none");
  else
    write.key("initial", "InitialCondition", "0");
  if (write.is_on("LimitOutput"))
    write.limit("lower", "LowerSaturationLimit", "-inf").limit("upper", "UpperSaturationLimit", "inf");
}

void require(const BlockWriter& write, const std::string& name, const std::string& only) {
  const std::string written = write.text(name, only);
  if (written != only)
    throw Untranslated(fmt::format("its {} is '{}', and only '{}' has a counterpart", name, written, only));
}

Value padded(const Value& polynomial, std::size_t count, bool at_end) {
  Value result{1, polynomial.cells.size(), polynomial.cells};
  while (result.cells.size() < count) {
    result.cells.insert(at_end ? result.cells.end() : result.cells.begin(), Cell{0.0});
    ++result.columns;
  }
  return result;
}

bool is_truth(FlatModel& model, const std::string& source) {
  const auto at = FlatModel::token_of(source);
  if (!at) return source == "0";
  static const std::set<std::string> types{"RelationalOperator", "Logic"};
  const Block& block = *model.blocks()[at->first].block;
  if (types.contains(block.type)) return true;
  const std::string library =
      block.type == "Reference" ? text_of(model.model(), block, "SourceBlock", "") : "";
  return library.find("Compare") != library.npos || library.find("Detect") != library.npos ||
         library.find("Interval") != library.npos;
}

}  // namespace stepwire::simulink
