#include "engine/simulate/codegen/tuning_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/codegen/statements.hpp"
#include "engine/simulate/codegen/value_text.hpp"
#include "engine/simulate/codegen/workspace_text.hpp"

namespace stepwire::codegen {

namespace {

/// Writes calls of prepare() as C++. A block is set up from parameters and prepares its members one element
/// at a time, so that none of them allocates memory.
class PreparedText {
 public:
  /// Function element(i, k) that returns number k of the value of the i-th binding of the tuning.
  using Element = std::function<std::string(std::size_t i, std::size_t k)>;

  PreparedText(const plan::Plan& plan, const Tuning& tuning, Element element)
      : plan_(plan), tuning_(tuning), element_(std::move(element)) {}

  std::string call(const PreparedBlock& block);
  /// Returns the definitions of lists that the calls read.
  std::string tables() const;

 private:
  std::string set_up(std::size_t block, std::size_t k);
  std::string member_text(std::size_t block, std::size_t member, std::size_t k);
  std::string from_binding(std::size_t block, const ParameterSpec& spec, std::size_t binding,
                           std::size_t k) const;

  const plan::Plan& plan_;
  const Tuning& tuning_;
  Element element_;
  Literals literals_;
};

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

bool varies(const std::vector<NumberText>& numbers) {
  return std::ranges::any_of(numbers, [](const NumberText& number) { return !number.constant; });
}

/// Returns "x[0]" for the numbers of the array x.
std::string first_of(const std::string& name, const Value& value) {
  return element_text(name, value, 0);
}

/// Returns the check that a condition of x holds for each number, with the message of the refusal.
std::string check_text(const std::string& first, std::size_t count, const std::string& condition,
                       const std::string& message) {
  return fmt::format("  if (!all_of(&{}, {}, [&](double x) {{ return {}; }})) return {};\n", first, count,
                     condition, cpp_string(message));
}

class TuningText {
 public:
  TuningText(const plan::Plan& plan, const Tuning& tuning)
      : plan_(plan), tuning_(tuning), values_(plan.diagram, [this](std::size_t d) { return name_of(d); }) {}

  std::string text() {
    add_dependents();
    for (const int d : tuning_.parameters) add_definition(static_cast<std::size_t>(d));
    for (std::size_t i = 0; i < tuning_.bindings.size(); ++i) add_binding(i);
    body_ += "  if (!numbers) return nullptr;\n";
    for (const Tuning::Copy& copy : tuning_.copies)
      body_ += fmt::format("  numbers[{}] = {};\n", copy.number, element(copy.binding, copy.element));
    PreparedText prepared(plan_, tuning_, [this](std::size_t i, std::size_t k) { return element(i, k); });
    for (const PreparedBlock& block : tuning_.prepared) body_ += prepared.call(block);
    for (std::size_t i = 0; i < dependents_.size(); ++i)
      body_ += fmt::format("  own[{0}] = is_own[{0}];\n", i);
    return head(prepared.tables()) + body_ + "  return nullptr;\n}\n\n";
  }

  std::size_t dependents() {
    add_dependents();
    return dependents_.size();
  }

 private:
  std::string name_of(std::size_t d) const {
    const auto found = tuning_.members.find(static_cast<int>(d));
    return found == tuning_.members.end() ? "" : "p." + found->second;
  }

  const diagram::Definition& definition(std::size_t d) const {
    return plan_.diagram.bindings->definitions[d];
  }
  const diagram::Binding& binding(std::size_t i) const {
    return plan_.diagram.bindings->bindings[static_cast<std::size_t>(tuning_.bindings[i])];
  }

  std::vector<NumberText> numbers(const diagram::ValueText& text) const {
    return *values_.numbers(text.node, text.names);
  }

  std::string head(const std::string& tables) const {
    return tables +
           "template <class Condition>\n"
           "inline bool all_of(const double* first, int count, const Condition& holds) {\n"
           "  for (int i = 0; i < count; ++i)\n    if (!holds(first[i])) return false;\n  return true;\n}\n\n"
           "/// Computes what follows from parameters; returns what is refused, and changes nothing then. "
           "Without numbers "
           "it checks\n/// the parameters only.\n"
           "[[gnu::noinline]] const char* follow_parameters(Diagram::Parameters& p, "
           "[[maybe_unused]] const Diagram::Parameters& before, [[maybe_unused]] bool* own, "
           "double* numbers) {\n";
  }

  /// True if a formula that only the loader computes depends on a parameter that may change.
  bool follows(const diagram::Definition& definition) const {
    const auto numbers = values_.numbers(definition.text.node, definition.text.names);
    return !definition.uses.empty() && numbers && varies(*numbers);
  }

  void add_dependents() {
    for (const int d : tuning_.parameters)
      if (follows(definition(static_cast<std::size_t>(d)))) dependents_.push_back(d);
    if (dependents_.empty()) return;
    body_ += fmt::format("  bool is_own[{}];\n", dependents_.size());
    for (std::size_t i = 0; i < dependents_.size(); ++i) {
      const std::string& member = tuning_.members.at(dependents_[i]);
      body_ += fmt::format(
          "  is_own[{0}] = own[{0}] || std::memcmp(&p.{1}, &before.{1}, sizeof p.{1}) != 0;\n", i, member);
    }
  }

  void add_definition(std::size_t d) {
    const diagram::DiagramParameter& parameter = plan_.diagram.parameters[d];
    const std::string name = name_of(d);
    const auto dependent = std::ranges::find(dependents_, static_cast<int>(d));
    if (dependent != dependents_.end()) {
      body_ += fmt::format("  if (!is_own[{}]) {{\n", dependent - dependents_.begin());
      const std::vector<NumberText> all = numbers(definition(d).text);
      for (std::size_t k = 0; k < all.size(); ++k)
        body_ += fmt::format("    {} = {};\n", element_text(name, parameter.value, k), all[k].text);
      body_ += "  }\n";
    }
    const std::string first = first_of(name, parameter.value);
    const std::size_t count = numbers_of(parameter.value).size();
    body_ += check_text(first, count, "std::isfinite(x)", parameter.name + ": must be a finite number");
    for (const yaml::Entry& bound : definition(d).bounds) add_bound(d, bound, first, count);
  }

  void add_bound(std::size_t d, const yaml::Entry& bound, const std::string& first, std::size_t count) {
    const std::string limit = numbers({bound.value, definition(d).scope, definition(d).scope}).front().text;
    const std::string sign = bound.key == "above"      ? ">"
                             : bound.key == "at_least" ? ">="
                             : bound.key == "below"    ? "<"
                                                       : "<=";
    std::string words = bound.key;
    std::replace(words.begin(), words.end(), '_', ' ');
    body_ += check_text(
        first, count, fmt::format("x {} {}", sign, limit),
        fmt::format("{}: must be {} {}", plan_.diagram.parameters[d].name, words, bound.value.text));
  }

  void add_binding(std::size_t i) {
    const std::vector<NumberText> all = numbers(binding(i).text);
    counts_.push_back(all.size());
    std::string texts;
    bool computed = false;
    for (const NumberText& number : all) {
      texts += (texts.empty() ? "" : ", ") + number.text;
      computed = computed || number.computed;
    }
    body_ += fmt::format("  const double value_{}[] = {{{}}};\n", i, texts);
    const std::string subject = stepwire::diagram::name_of(plan_.diagram, binding(i).target);
    const auto check = [&](const std::string& condition, const std::string& must) {
      body_ += check_text(fmt::format("value_{}[0]", i), all.size(), condition,
                          fmt::format("{}: must be {}", subject, must));
    };
    if (computed) check("std::isfinite(x)", "a finite number");
    if (binding(i).target.kind == diagram::Target::Kind::parameter)
      add_range(spec_of(binding(i).target), check);
  }

  const ParameterSpec& spec_of(const diagram::Target& target) const {
    return plan_.diagram.blocks[static_cast<std::size_t>(target.block)]
        .type()
        .parameters[static_cast<std::size_t>(target.index)];
  }

  template <class Check>
  static void add_range(const ParameterSpec& spec, const Check& check) {
    const auto side = [&](const std::optional<double>& limit, const char* sign, const char* words) {
      if (limit)
        check(fmt::format("x {} {}", sign, number_text(*limit)), fmt::format("{} {}", words, *limit));
    };
    side(spec.range.above, ">", "above");
    side(spec.range.at_least, ">=", "at least");
    side(spec.range.below, "<", "below");
    side(spec.range.at_most, "<=", "at most");
    if (spec.kind == ParameterKind::integer)
      check("std::floor(x) == x && std::abs(x) < 9e15", "a whole number");
  }

  /// Returns element k of a binding's value, or its single number for all elements.
  std::string element(std::size_t binding, std::size_t k) const {
    return fmt::format("value_{}[{}]", binding, counts_[binding] == 1 ? 0 : k);
  }

  const plan::Plan& plan_;
  const Tuning& tuning_;
  ValueTexts values_;
  std::vector<int> dependents_;
  std::vector<std::size_t> counts_;  ///< count of numbers of each binding
  std::string body_;
};

}  // namespace

std::size_t dependent_count(const plan::Plan& plan, const Tuning& tuning) {
  return TuningText(plan, tuning).dependents();
}

std::string tuning_text(const plan::Plan& plan, const Tuning& tuning) {
  return TuningText(plan, tuning).text();
}

}  // namespace stepwire::codegen
