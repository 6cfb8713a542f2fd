#include "blocks/math/expression.hpp"

#include <fmt/format.h>

#include <charconv>

#include "engine/block/declare.hpp"
#include "engine/expression/expression_function.hpp"

namespace stepwire {

namespace {

/// Which input a name of a formula is, from 0: u1 is the first, and u is a name for it too; -1 if it is none.
Index input_of(std::string_view name) {
  if (name == "u") return 0;
  if (name.size() < 2 || name[0] != 'u' || name[1] == '0') return -1;
  Index number = 0;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() ? number - 1 : -1;
}

Function read_formula(const ExpressionBlock& block, Index inputs, const Configure& is) {
  const auto known = [&](std::string_view name) {
    const Index index = input_of(name);
    return index >= 0 && index < inputs;
  };
  try {
    Expression expression(block.expression, known);
    std::vector<std::size_t> places;
    for (const std::string& name : expression.variables())
      places.push_back(static_cast<std::size_t>(input_of(name)));
    return function_of(std::move(expression), std::move(places));
  } catch (const ExpressionError& error) {
    is.refuse<&ExpressionBlock::expression>(fmt::format(
        "'{}', character {}: {}; it may use u1 to u{}, and for the time the output of a Clock among them",
        block.expression.view(), error.position + 1, error.what(), inputs));
  }
}

}  // namespace

void ExpressionBlock::configure(Configure& is) {
  const Index inputs = is.count<&ExpressionBlock::u>();
  if (inputs > most_inputs)
    is.refuse<&ExpressionBlock::expression>(
        fmt::format("{} inputs are more than {}; combine some of them in an Expression of their own", inputs,
                    most_inputs));
  formula = read_formula(*this, inputs, is);
}

void ExpressionBlock::declare(Declare<ExpressionBlock>& is) {
  is.block(
      "Expression",
      {.doc = "A formula over its inputs, element by element. u1 is the first of the list u, u2 the second, "
              "and u is "
              "another name for u1. Numbers of the formula may carry units (`u1 > 4 mm`); its value is taken "
              "as SI. "
              "For the time feed the output of a Clock. Blocks of their own are faster and check units.",
       .symbol = {.text = "{expression|f(u)}"}});
  is.parameter<&ExpressionBlock::expression>(
      {.doc = "+ - * / ^ ( ), comparisons, && || !, cond ? a : b; sin cos tan asin acos atan atan2 sinh cosh "
              "tanh exp log "
              "log10 log2 sqrt cbrt abs sign floor ceil round min max mod hypot; pi, e"});
  is.input<&ExpressionBlock::u>(
      {.unit = "*", .doc = "signals; one element counts for every element of the others"});
  is.output<&ExpressionBlock::y>({.unit = "*", .doc = "the value"});
  is.derived<&ExpressionBlock::formula>();
}

}  // namespace stepwire
