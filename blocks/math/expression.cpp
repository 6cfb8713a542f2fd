#include "blocks/math/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "engine/base/expression/expression_function.hpp"
#include "engine/base/expression/margin.hpp"
#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

/// Returns the index of the input with this name in a formula: u1 is 0, and u is another name for it. Returns
/// -1 for any other name.
Index input_of(std::string_view name) {
  if (name == "u") return 0;
  if (name.size() < 2 || name[0] != 'u' || name[1] == '0') return -1;
  Index number = 0;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() ? number - 1 : -1;
}

/// Names of the inputs in a block's formula.
class InputNames {
 public:
  InputNames(const std::vector<std::string>& variables, Index inputs)
      : variables_(variables), inputs_(inputs) {}

  /// Returns the index of an input; -1 for an unknown name.
  Index operator()(std::string_view name) const {
    if (variables_.empty()) return input_of(name) < inputs_ ? input_of(name) : -1;
    const auto found = std::find(variables_.begin(), variables_.end(), name);
    return found == variables_.end() ? -1 : found - variables_.begin();
  }
  std::string text() const {
    return variables_.empty() ? fmt::format("u1 to u{}", inputs_)
                              : fmt::format("{}", fmt::join(variables_, ", "));
  }

 private:
  const std::vector<std::string>& variables_;
  Index inputs_;
};

/// Makes functions of a block from expressions over the names of its inputs and the modes of its formula.
struct MakeFunction {
  const InputNames& inputs;
  const std::vector<std::string>& modes{};

  Function operator()(const expression::Expression& of) const {
    std::vector<std::size_t> places;
    for (const std::string& name : of.variables()) places.push_back(place(name));
    return expression::function_of(of, places);
  }

 private:
  std::size_t place(const std::string& name) const {
    if (inputs(name) >= 0) return static_cast<std::size_t>(inputs(name));
    const auto mode = std::ranges::find(modes, name) - modes.begin();
    return static_cast<std::size_t>(ExpressionBlock::max_inputs + mode);
  }
};

/// Holds the jumps of a formula between instants, as far as they are located.
void hold_jumps(ExpressionBlock& block, const expression::Expression& formula, const InputNames& names,
                Configure& is) {
  const expression::Held held = expression::held_of(formula, block.margins.size());
  block.held = MakeFunction{names, held.names}(held.formula);
  std::ranges::transform(held.modes, block.modes_of.begin(), MakeFunction{names});
  is.size("k", static_cast<Index>(held.modes.size()));
  if (!held.modes.empty()) return is.hold_mode(block.holds_modes);
  is.skip_instants();
  is.remember_nothing();
}

/// Prepares the crossings of a formula, and what it holds between them.
void locate(ExpressionBlock& block, const expression::Expression& formula, const InputNames& names,
            Configure& is) {
  const expression::Branches branches = expression::branches_of(formula);
  const bool steady = branches.steady && branches.margins.size() <= block.margins.size();
  for (std::size_t i = 0; i < std::min(branches.margins.size(), block.margins.size()); ++i)
    block.margins[i] = MakeFunction{names}(branches.margins[i]);
  if (branches.margins.empty()) is.skip_crossings();
  if (!steady) return hold_jumps(block, formula, names, is);
  is.steady();
  is.size("k", 0);
  is.skip_instants();
  is.remember_nothing();
}

void read_formula(ExpressionBlock& block, Index inputs, Configure& is) {
  const InputNames names(block.variables, inputs);
  try {
    const expression::Expression formula(block.expression,
                                         [&](std::string_view name) { return names(name) >= 0; });
    block.formula = MakeFunction{names}(formula);
    locate(block, formula, names, is);
  } catch (const expression::ExpressionError& error) {
    is.refuse<&ExpressionBlock::expression>(fmt::format(
        "'{}', character {}: {}; it may use {}, and for the time the output of a Clock among them",
        block.expression.view(), error.position + 1, error.what(), names.text()));
  }
}

}  // namespace

template <>
void ExpressionBlock::configure(Configure& is) {
  const Index inputs = is.count<&ExpressionBlock::u>();
  if (inputs > max_inputs)
    is.refuse<&ExpressionBlock::expression>(
        fmt::format("{} inputs are more than {}; combine some of them in an Expression of their own", inputs,
                    max_inputs));
  if (!variables.empty() && static_cast<Index>(variables.size()) != inputs)
    is.refuse<&ExpressionBlock::variables>(fmt::format("{} for {}; each needs one",
                                                       text::there_are(variables.size(), "name"),
                                                       text::counted(inputs, "input")));
  read_formula(*this, inputs, is);
}

namespace {

void declare_block(Declare<ExpressionBlock>& is) {
  is.block(
      "Expression",
      {.doc = "A formula over its inputs, element by element. u1 is the first of the list u, u2 the second, "
              "and u is "
              "another name for u1. Numbers of the formula may carry units (`u1 > 4 mm`); its value is taken "
              "as SI, in the unit of what it feeds or of the section `units`. "
              "For the time feed the output of a Clock. Sums and comparisons of signals with different units "
              "are "
              "refused. Blocks of their own are faster. With "
              "`events: locate` the first four places where it breaks are located: conditions, and the jumps "
              "and bends of abs, sign, floor, ceil, round, min, max and mod (not the jump of atan2). Between "
              "two "
              "instants the formula keeps the branch of each of these jumps: x*sign(x) is -x, or it is x.",
       .symbol = {.text = "{expression|f(u)}"}});
}

}  // namespace

template <>
void ExpressionBlock::declare(Declare<ExpressionBlock>& is) {
  declare_block(is);
  is.parameter<&ExpressionBlock::expression>(
      {.doc = "+ - * / ^ ( ), comparisons, && || !, cond ? a : b; sin cos tan asin acos atan atan2 sinh cosh "
              "tanh exp log "
              "log10 log2 sqrt cbrt abs sign floor ceil round min max mod hypot lognormal; pi, e; names of "
              "parameters",
       .formulas = {""}});
  is.parameter<&ExpressionBlock::variables>(
      {.doc = "names of the inputs in the formula, in their order: [x, y]; u1, u2, ... where left out"});
  is.input<&ExpressionBlock::u>(
      {.unit = "*", .doc = "signals; one element counts for every element of the others"});
  is.output<&ExpressionBlock::y>({.unit = "*", .doc = "the value"});
  for (const char* which : {"first", "second", "third", "fourth"})
    is.crossing<&ExpressionBlock::u>(fmt::format("the {} condition of the formula changes", which));
  is.state<&ExpressionBlock::modes>(
      {.shape = "k x n", .doc = "branches of the formula, jump by jump", .settable = false, .mode = true});
  is.derived<&ExpressionBlock::formula>();
  is.derived<&ExpressionBlock::margins>();
  is.derived<&ExpressionBlock::held>();
  is.derived<&ExpressionBlock::modes_of>();
  is.derived<&ExpressionBlock::holds_modes>();
}

}  // namespace stepwire
