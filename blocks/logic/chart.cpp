#include "blocks/logic/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stepwire {
namespace {

class Choice final : public Function::Source {
 public:
  Choice(std::vector<ChartFormula> formulas, std::size_t place)
      : formulas_(std::move(formulas)), place_(place) {}

  double operator()(const double* v) const override {
    if (formulas_.empty()) return 0.0;
    const ChartFormula& chosen = formulas_[static_cast<std::size_t>(v[place_])];
    return chosen.formula(v, chosen.places);
  }

  /// Returns "v[2] == 0.0 ? double(A) : v[2] == 1.0 ? double(B) : double(C)".
  std::string cpp() const override {
    if (formulas_.empty()) return "0.0";
    std::string text;
    for (std::size_t i = 0; i + 1 < formulas_.size(); ++i)
      text += fmt::format("{} == {}.0 ? {} : ", expression::element_of_v(place_), i, cpp_of(formulas_[i]));
    return text + cpp_of(formulas_.back());
  }

 private:
  static std::string cpp_of(const ChartFormula& formula) {
    return fmt::format("double({})", formula.formula.cpp([&](std::size_t i) {
      return expression::element_of_v(formula.places[i]);
    }));
  }

  std::vector<ChartFormula> formulas_;
  std::size_t place_;
};

std::size_t position_in(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? ChartNames::none : static_cast<std::size_t>(found - names.begin());
}

}  // namespace

std::size_t ChartNames::counter(std::string_view name) const {
  return position_in(counters, name);
}

std::size_t ChartNames::place(std::string_view name) const {
  if (name == "after") return after();
  if (const std::size_t found = counter(name); found != none) return input_count + found;
  if (!inputs.empty()) return position_in(inputs, name);
  if (name == "u" && input_count == 1) return 0;
  for (std::size_t i = 0; i < input_count; ++i)
    if (name == "u" + std::to_string(i + 1)) return i;
  return none;
}

std::string ChartNames::text() const {
  std::string all = !inputs.empty()    ? fmt::format("{}", fmt::join(inputs, ", "))
                    : input_count == 0 ? "no inputs"
                    : input_count == 1 ? "u"
                                       : fmt::format("u1 to u{}", input_count);
  if (!counters.empty()) all += fmt::format(", {}", fmt::join(counters, ", "));
  return all + " and after";
}

ChartFormulas::ChartFormulas(ChartNames names, ChartRefuse refuse)
    : names_(std::move(names)), refuse_(std::move(refuse)) {}

std::vector<ChartSetting> ChartFormulas::settings(const std::string& subject, const Value& map) const {
  if (!map.map()) refuse_(subject + " must be a map of counter: formula", map);
  std::vector<ChartSetting> settings;
  for (const auto& [name, value] : *map.map()) {
    const std::size_t counter = names_.counter(name);
    if (counter == ChartNames::none)
      refuse_(fmt::format("{} sets '{}', which is no counter; {}", subject, name,
                          names_.counters.empty()
                              ? "name them with their first values: counters: {tries: 0}"
                              : fmt::format("the counters are {}", fmt::join(names_.counters, ", "))),
              value);
    if (!value.text()) refuse_(fmt::format("{} must be a formula", subject), value);
    settings.push_back({counter, read(subject, *value.text(), value)});
  }
  return settings;
}

ChartFormula ChartFormulas::read(const std::string& subject, const std::string& text,
                                 const Value& where) const {
  try {
    ChartFormula made{
        expression::Expression(text, [&](std::string_view n) { return names_.place(n) != ChartNames::none; }),
        {}};
    std::vector<expression::Measure> measures;
    for (const std::string& name : made.formula.variables()) {
      made.places.push_back(names_.place(name));
      const bool is_time = made.places.back() == names_.after();
      measures.push_back(is_time ? expression::Measure{unit::parse_unit("s")->dimension, true}
                                 : expression::Measure{});
    }
    static_cast<void>(made.formula.measure(measures));
    return made;
  } catch (const expression::ExpressionError& error) {
    refuse_(fmt::format("{}, '{}': {}; it may read {}", subject, text, error.what(), names_.text()), where);
    throw;
  }
}

double ChartFormulas::number(const std::string& state, const Value& tree) const {
  double number = std::numeric_limits<double>::quiet_NaN();
  try {
    if (tree.text())
      number = expression::Expression(*tree.text(), [](std::string_view) { return false; })({});
  } catch (const expression::ExpressionError&) {
  }
  if (!std::isfinite(number))
    refuse_(fmt::format("'{}' in the output of state '{}' is no finite number",
                        tree.text() ? *tree.text() : "this", state),
            tree);
  return number;
}

Function choice_of(std::vector<ChartFormula> formulas, std::size_t place_of_choice) {
  return Function(std::make_shared<Choice>(std::move(formulas), place_of_choice));
}

}  // namespace stepwire
