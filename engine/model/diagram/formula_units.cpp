#include "engine/model/diagram/formula_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/expression/expression.hpp"
#include "engine/base/unit/meaning.hpp"
#include "engine/model/diagram/unit_faults.hpp"
#include "engine/model/diagram/units.hpp"

namespace stepwire::diagram {

namespace {

using expression::Expression;
using expression::ExpressionError;
using expression::Measure;

/// Formulas of one block and the units of their variables.
class BlockFormulas {
 public:
  BlockFormulas(const DiagramBlock& block, Report& report) : block_(block), report_(report) {
    for (const ParameterSpec& spec : block.type().parameters) {
      const Value value = spec.get(block.block.get());
      if (spec.kind == ParameterKind::texts) add_words(value);
      if (spec.kind == ParameterKind::tree && spec.formulas.empty() && value.map())
        for (const ValueEntry& entry : *value.map()) numbers_.push_back(entry.key);
    }
    for (std::size_t i = 0; i < block.inputs.size(); ++i)
      if (block.type().inputs[i].list) sources_ = &block.inputs[i];
  }

  void check() {
    if (!sources_) return;
    for (std::size_t p = 0; p < block_.type().parameters.size(); ++p) {
      const ParameterSpec& spec = block_.type().parameters[p];
      if (spec.formulas.empty()) continue;
      parameter_ = p;
      walk(spec.get(block_.block.get()), spec.formulas);
    }
  }

 private:
  void add_words(const Value& value) {
    if (const auto* words = value.list())
      for (const Value& word : *words)
        if (word.text()) words_.push_back(*word.text());
  }

  /// Visits the formulas of a tree by their keys, see ParameterOptions::formulas.
  void walk(const Value& value, const std::vector<std::string>& keys) {
    const auto is_key = [&](const std::string& key) { return std::ranges::find(keys, key) != keys.end(); };
    if (value.text() && is_key("")) check(value);
    if (const auto* list = value.list())
      for (const Value& item : *list) walk(item, keys);
    if (!value.map()) return;
    for (const auto& [key, item] : *value.map()) {
      const bool are_formulas =
          is_key("") || (!item.list() && is_key(key)) || (item.map() && is_key(key + "."));
      walk(item, are_formulas ? std::vector<std::string>{""} : keys);
    }
  }

  /// Reports a formula that joins different units. Invalid formulas are refused by their block.
  void check(const Value& text) {
    std::optional<Expression> formula;
    try {
      formula.emplace(*text.text(), [this](std::string_view name) { return knows(std::string(name)); });
    } catch (const ExpressionError&) {
      return;
    }
    std::vector<Measure> measures;
    for (const std::string& name : formula->variables()) measures.push_back(measure_of(name));
    try {
      refuse_zeros(formula->measure(measures));
    } catch (const ExpressionError& error) {
      refuse(text, *formula, measures, error);
    }
  }

  /// Throws ExpressionError for a value that is neither a temperature nor a difference of temperatures.
  static void refuse_zeros(const Measure& value) {
    if (!value.dimension) return;
    const std::string other = unit::other_meaning(*value.dimension, *value.dimension);
    if (!other.empty()) throw ExpressionError("the value " + other, 0);
  }

  /// True for the names that the block knows: any other one after a number is a unit.
  bool knows(const std::string& name) const {
    return input_of(name) < sources_->size() || name == "after" ||
           std::ranges::find(numbers_, name) != numbers_.end();
  }

  Measure measure_of(const std::string& name) const {
    const std::size_t input = input_of(name);
    if (std::ranges::find(numbers_, name) != numbers_.end()) return {};
    if (input >= sources_->size())
      return name == "after" ? Measure{unit::parse_unit("s")->dimension, true} : Measure{};
    const Source& source = (*sources_)[input];
    const auto dimension =
        source.block < 0 ? source.dimension
                         : dimension_of(report_.about(), {source.block, source.output, -1, source.element});
    return {dimension, dimension.has_value()};
  }

  /// Returns the index of the input of a name; the count of inputs for other names.
  std::size_t input_of(const std::string& name) const {
    const std::size_t none = sources_->size();
    if (!words_.empty()) {
      const auto found = static_cast<std::size_t>(std::ranges::find(words_, name) - words_.begin());
      return found < words_.size() ? found : none;
    }
    for (std::size_t i = 0; i < none; ++i)
      if (name == fmt::format("u{}", i + 1)) return i;
    return name == "u" ? 0 : none;
  }

  /// Returns the name of a variable with its source: "u1 (spring)".
  std::string shown(const std::string& name) const {
    const std::size_t input = input_of(name);
    const bool has_source = input < sources_->size() && (*sources_)[input].block >= 0;
    return has_source ? fmt::format("{} ({})", name, UnitFaults(report_).name_of((*sources_)[input])) : name;
  }

  void refuse(const Value& text, const Expression& formula, const std::vector<Measure>& measures,
              const ExpressionError& error) {
    std::vector<std::string> units;
    for (std::size_t i = 0; i < measures.size(); ++i)
      if (measures[i].dimension)
        units.push_back(
            fmt::format("{} is in {}", shown(formula.variables()[i]), unit::si_name(*measures[i].dimension)));
    const yaml::Mark own = block_.parameter_marks[parameter_];
    const yaml::Mark mark = text.line > 0 ? yaml::Mark{text.line, text.column} : own;
    const std::string where = units.empty() ? "" : fmt::format(", where {}", fmt::join(units, ", "));
    std::string wrong = error.what(), cure = "give a number its unit, or divide a value by one, as u1/(1 m)";
    if (const std::size_t end = wrong.find("; "); end != wrong.npos) {
      cure = wrong.substr(end + 2) + (wrong.find("; they must", end) == end ? ": " + cure : "");
      wrong.resize(end);
    }
    report_.add(
        {block_.origin.scope, mark}, block_.name + "." + block_.type().parameters[parameter_].name,
        {fmt::format("'{}', character {}: {}{}", *text.text(), error.position + 1, wrong, where), cure});
  }

  const DiagramBlock& block_;
  Report& report_;
  std::vector<std::string> words_;    ///< names of the inputs; empty: u1, u2, ...
  std::vector<std::string> numbers_;  ///< counters and other numbers of the block
  const std::vector<Source>* sources_ = nullptr;
  std::size_t parameter_ = 0;
};

/// Base units of Dimension::exponents, and the angle.
constexpr std::array<const char*, 8> base_units{"m", "kg", "s", "A", "K", "mol", "cd", "rad"};
constexpr std::size_t kelvin = 4;

}  // namespace

void check_formulas(Report& report) {
  for (const DiagramBlock& block : report.about().blocks)
    if (std::ranges::any_of(block.type().parameters, [](const auto& spec) { return !spec.formulas.empty(); }))
      BlockFormulas(block, report).check();
}

std::string quantity_in_formula(double value, const unit::Dimension& dimension) {
  const std::string bare = value < 0 ? fmt::format("({})", value) : fmt::format("{}", value);
  const std::string name = unit::meaning_name(dimension);
  if (name == "1") return bare;
  if (std::ranges::all_of(name, [](unsigned char letter) { return std::isalpha(letter) || letter == '_'; }))
    return fmt::format("({} {})", value, name);
  std::array<double, 8> exponents{};
  std::ranges::copy(dimension.exponents, exponents.begin());
  exponents.back() = dimension.angle;
  std::vector<std::string> above, below;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    if (std::floor(exponents[i]) != exponents[i]) return bare;
    for (double k = 0.0; k < std::abs(exponents[i]); ++k)
      (exponents[i] > 0 ? above : below)
          .push_back(i == kelvin && dimension.per_difference ? "delta_degC" : base_units[i]);
  }
  if (above.empty()) {  // 1/s is m/m/s: the number needs a unit of its own
    above.emplace_back("m");
    below.emplace_back("m");
  }
  std::string text = fmt::format("({} {}", value, above.front());
  for (std::size_t i = 1; i < above.size(); ++i) text += " * 1 " + above[i];
  for (const std::string& unit : below) text += " / 1 " + unit;
  return text + ")";
}

}  // namespace stepwire::diagram
