#include "blocks/logic/chart.hpp"

#include <fmt/format.h>

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

  /// "v[2] == 0.0 ? double(A) : v[2] == 1.0 ? double(B) : double(C)"
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

}  // namespace

Function choice_of(std::vector<ChartFormula> formulas, std::size_t place_of_choice) {
  return Function(std::make_shared<Choice>(std::move(formulas), place_of_choice));
}

}  // namespace stepwire
