#include "engine/model/diagram/unit_equations.hpp"

#include <deque>

namespace stepwire::diagram {

void UnitEquations::add(UnitEquation equation, std::string what) {
  std::erase_if(equation.terms, [](const auto& term) { return term.second == 0.0; });
  equation.what = std::move(what);
  equations_.push_back(std::move(equation));
}

/// The equations in which each variable stands.
std::vector<std::vector<int>> UnitEquations::users() const {
  std::vector<std::vector<int>> users(values_.size());
  for (std::size_t i = 0; i < equations_.size(); ++i)
    for (const auto& [variable, exponent] : equations_[i].terms)
      users[static_cast<std::size_t>(variable)].push_back(static_cast<int>(i));
  return users;
}

void UnitEquations::solve(std::size_t variables, const Complain& complain) {
  values_.resize(variables);
  in_question_.resize(variables);
  const std::vector<std::vector<int>> users = this->users();
  std::deque<int> queue;
  for (std::size_t i = 0; i < equations_.size(); ++i) queue.push_back(static_cast<int>(i));
  while (!queue.empty()) {
    UnitEquation& equation = equations_[static_cast<std::size_t>(queue.front())];
    queue.pop_front();
    equation.queued = false;
    const int solved = step(equation, complain);
    if (solved < 0) continue;
    for (int user : users[static_cast<std::size_t>(solved)]) {
      UnitEquation& other = equations_[static_cast<std::size_t>(user)];
      if (other.queued || &other == &equation) continue;
      other.queued = true;
      queue.push_back(user);
    }
  }
  find_angles();
}

/// Lets numbers that are a pure ratio or a rate be angles where their equations hold only so: rad is 1, so
/// that no equation is wrong without. Each becomes one once.
void UnitEquations::find_angles() {
  const std::vector<std::vector<int>> users = this->users();
  std::deque<int> queue;
  for (std::size_t i = 0; i < equations_.size(); ++i) queue.push_back(static_cast<int>(i));
  while (!queue.empty()) {
    const int turned = turn_to_angle(equations_[static_cast<std::size_t>(queue.front())]);
    queue.pop_front();
    if (turned < 0) continue;
    for (const int user : users[static_cast<std::size_t>(turned)]) queue.push_back(user);
  }
}

/// The variable that is an angle now; -1 where none is.
int UnitEquations::turn_to_angle(const UnitEquation& equation) {
  const auto sum = dimension_of(equation);
  if (!sum || sum->angle == 0.0) return -1;
  for (const auto& [variable, exponent] : equation.terms) {
    auto& value = values_[static_cast<std::size_t>(variable)];
    if (value->angle != 0.0 || sum->angle + exponent != 0.0) continue;
    unit::Dimension rate = *value;
    rate.exponents[2] = 0.0;
    if (rate != unit::Dimension{} || value->exponents[2] > 0.0) continue;
    value->angle = 1.0;
    return variable;
  }
  return -1;
}

/// Solves for the only unknown variable and returns it; checks where none is unknown; -1 where nothing is
/// learnt.
int UnitEquations::step(const UnitEquation& equation, const Complain& complain) {
  unit::Dimension known = equation.constant;
  int unknown = -1;
  double exponent = 0.0;
  for (const auto& [variable, power_of] : equation.terms) {
    const auto& value = values_[static_cast<std::size_t>(variable)];
    if (value) {
      known = known * unit::power(*value, power_of);
    } else {
      if (unknown >= 0) return -1;
      unknown = variable;
      exponent = power_of;
    }
  }
  if (unknown < 0) {
    if (known != unit::Dimension{} && !follows_from_another(equation)) complain(equation, known);
    return -1;
  }
  values_[static_cast<std::size_t>(unknown)] = unit::power(known, -1.0 / exponent);
  return unknown;
}

/// Once a unit is in question, all that it is held against would be told as well.
bool UnitEquations::follows_from_another(const UnitEquation& equation) {
  bool known = false;
  for (const auto& [variable, exponent] : equation.terms) {
    known = known || in_question_[static_cast<std::size_t>(variable)];
    in_question_[static_cast<std::size_t>(variable)] = true;
  }
  return known;
}

std::optional<unit::Dimension> UnitEquations::dimension_of(const UnitEquation& product) const {
  unit::Dimension result = product.constant;
  for (const auto& [variable, exponent] : product.terms) {
    const auto& value = values_[static_cast<std::size_t>(variable)];
    if (!value) return std::nullopt;
    result = result * unit::power(*value, exponent);
  }
  return result;
}

}  // namespace stepwire::diagram
