#include "blocks/logic/stages.hpp"

#include <fmt/format.h>

#include <utility>

namespace stepwire {
namespace {

std::string cpp_of(const Guard& guard) {
  return guard.formula.cpp_condition(
      [&](std::size_t i) { return expression::element_of_v(guard.places[i]); });
}

/// Guards are read in the order of the file; the first that holds decides.
class Successor final : public Function::Source {
 public:
  Successor(const std::vector<Stage>& stages, std::size_t inputs) : place_of_stage_(inputs + 1) {
    for (const Stage& stage : stages) to_.push_back(stage.to);
  }

  double operator()(const double* v) const override {
    const double now = v[place_of_stage_];
    for (const Transition& transition : to_[static_cast<std::size_t>(now)])
      if (transition.guard.formula(v, transition.guard.places) != 0.0)
        return static_cast<double>(transition.target);
    return now;
  }

  /// "v[2] == 0.0 ? (GUARD ? 1.0 : 0.0) : v[2] == 1.0 ? ... : 2.0"
  std::string cpp() const override {
    std::string text;
    for (std::size_t i = 0; i + 1 < to_.size(); ++i)
      text += fmt::format("{} == {}.0 ? ({}) : ", expression::element_of_v(place_of_stage_), i, following(i));
    return text + following(to_.size() - 1);
  }

 private:
  std::string following(std::size_t stage) const {
    std::string text;
    for (const Transition& transition : to_[stage])
      text += fmt::format("({}) ? {}.0 : ", cpp_of(transition.guard), transition.target);
    return text + fmt::format("{}.0", stage);
  }

  std::vector<std::vector<Transition>> to_;
  std::size_t place_of_stage_;
};

}  // namespace

Function successor_among(const std::vector<Stage>& stages, std::size_t inputs) {
  return Function(std::make_shared<Successor>(stages, inputs));
}

}  // namespace stepwire
