#include "engine/simulate/codegen/prepared_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/codegen/statements.hpp"
#include "engine/simulate/codegen/value_text.hpp"
#include "engine/simulate/codegen/workspace_text.hpp"

namespace stepwire::codegen {

std::string PreparedText::call(const PreparedBlock& block) {
  const auto& members = plan_.diagram.blocks[block.block].type().members;
  const auto element_of = [&](const PreparedBlock::Number& number) {
    return members[number.member].prepared.by_element ? number.part : 0;
  };
  std::size_t last = 0;
  for (const PreparedBlock::Number& number : block.numbers) last = std::max(last, element_of(number));
  std::string text;
  for (std::size_t k = 0; k <= last; ++k) {
    text += fmt::format("  {{  // {}\n    {} b;\n{}    b.prepare();\n", comment_of(plan_, block.block),
                        struct_of(plan_, block.block), set_up(block.block, k));
    for (const PreparedBlock::Number& number : block.numbers)
      if (element_of(number) == k)
        text += fmt::format("    numbers[{}] = b.{}{};\n", number.number, members[number.member].member,
                            members[number.member].prepared.text(static_cast<Index>(number.part)));
    text += "  }\n";
  }
  return text;
}

std::string PreparedText::set_up(std::size_t block, std::size_t k) {
  const BlockType& type = plan_.diagram.blocks[block].type();
  std::string text;
  for (std::size_t m = 0; m < type.members.size(); ++m)
    if (!type.members[m].prepared.put)
      text += fmt::format("    b.{} = {};\n", type.members[m].member, member_text(block, m, k));
  for (const ClockSpec& clock : type.clocks)
    if (clock.bind_period)
      text += fmt::format("    b.{}.bind({});\n", clock.member, period_text(plan_, block));
  return text;
}

std::string PreparedText::member_text(std::size_t block, std::size_t member, std::size_t k) {
  const diagram::DiagramBlock& from = plan_.diagram.blocks[block];
  const auto& parameters = from.type().parameters;
  const auto spec = std::ranges::find(parameters, static_cast<int>(member), &ParameterSpec::member);
  if (spec != parameters.end()) {
    const auto index = static_cast<int>(spec - parameters.begin());
    for (std::size_t i = 0; i < tuning_.bindings.size(); ++i) {
      const diagram::Target& target =
          plan_.diagram.bindings->bindings[static_cast<std::size_t>(tuning_.bindings[i])].target;
      if (target == diagram::Target{diagram::Target::Kind::parameter, static_cast<int>(block), index, 0})
        return from_binding(block, *spec, i, k);
    }
    if (spec->kind == ParameterKind::per_element) {
      const std::vector<double> numbers = numbers_of(spec->get(from.block.get()));
      return number_text(numbers[numbers.size() == 1 ? 0 : k]);
    }
  }
  literals_.name_tables(fmt::format("prepare_{}_{}", block, from.type().members[member].member));
  return from.type().members[member].literal(from.block.get(), literals_);
}

std::string PreparedText::from_binding(std::size_t block, const ParameterSpec& spec, std::size_t binding,
                                       std::size_t k) const {
  const Value value = spec.get(plan_.diagram.blocks[block].block.get());
  const std::size_t count = numbers_of(value).size();
  const std::string list = fmt::format("Numbers::view(&{}, {})", element_(binding, 0), count);
  switch (spec.kind) {
    case ParameterKind::integer:
      return fmt::format("static_cast<std::int64_t>({})", element_(binding, 0));
    case ParameterKind::vector:
      return list;
    case ParameterKind::matrix: {
      const auto& matrix = std::get<Eigen::MatrixXd>(value.content);
      return fmt::format("Matrix({}, {}, {})", matrix.rows(), matrix.cols(), list);
    }
    default:
      return element_(binding, count == 1 ? 0 : k);
  }
}

std::string PreparedText::tables() const {
  const std::string tables = literals_.tables();
  return tables.empty() ? "" : "namespace table {\n" + tables + "}  // namespace table\n\n";
}

}  // namespace stepwire::codegen
