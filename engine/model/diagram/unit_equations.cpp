#include "engine/model/diagram/unit_equations.hpp"

#include <algorithm>

#include "engine/base/unit/meaning.hpp"

namespace stepwire::diagram {

void UnitEquations::add(UnitEquation equation, std::string what) {
  std::erase_if(equation.terms, [](const UnitTerm& term) { return term.exponent == 0.0; });
  equation.what = std::move(what);
  equations_.push_back(std::move(equation));
}

void UnitEquations::find_users() {
  users_.resize(values_.size());
  for (std::size_t i = 0; i < equations_.size(); ++i)
    for (const UnitTerm& term : equations_[i].terms)
      users_[static_cast<std::size_t>(term.variable)].push_back(static_cast<int>(i));
}

void UnitEquations::solve(std::size_t variables, const Complain& complain) {
  values_.resize(variables);
  set_by_.resize(variables, -1);
  in_question_.resize(variables);
  kinds_.resize(variables, Elements::own);
  defined_first_.resize(variables);
  for (const int variable : defined_) defined_first_[static_cast<std::size_t>(variable)] = true;
  find_users();
  for (std::size_t i = 0; i < equations_.size(); ++i) queue_.push_back(static_cast<int>(i));
  do drain(complain);
  while (join_known() || solve_late(Stage::products, complain) || assume_pure_factors() || join_rest() ||
         solve_late(Stage::elements, complain));
  find_angles();
  check_rates(complain);
}

void UnitEquations::drain(const Complain& complain) {
  while (!queue_.empty()) {
    UnitEquation& equation = equations_[static_cast<std::size_t>(queue_.front())];
    queue_.pop_front();
    equation.queued = false;
    step(equation, complain);
  }
}

void UnitEquations::set(int variable, ElementUnits units) {
  const auto index = static_cast<std::size_t>(variable);
  values_[index] = std::move(units);
  for (const int user : users_[index]) {
    UnitEquation& other = equations_[static_cast<std::size_t>(user)];
    if (!other.queued) queue_.push_back(user);
    other.queued = true;
  }
}

/// Marks pure ratios and rates as angles if their equations then hold for angles. The radian is 1, so no
/// equation is wrong without this step. Each value changes at most once.
void UnitEquations::find_angles() {
  std::deque<int> queue;
  for (std::size_t i = 0; i < equations_.size(); ++i) queue.push_back(static_cast<int>(i));
  while (!queue.empty()) {
    const int turned = turn_to_angle(equations_[static_cast<std::size_t>(queue.front())]);
    queue.pop_front();
    if (turned < 0) continue;
    for (const int user : users_[static_cast<std::size_t>(turned)]) queue.push_back(user);
  }
}

/// Turns one variable of an equation into an angle and returns it; -1 without a suitable one.
int UnitEquations::turn_to_angle(const UnitEquation& equation) {
  const auto product = dimension_of(equation);
  const auto sum = product ? product->one() : std::nullopt;
  if (!sum || sum->angle == 0.0) return -1;
  for (const UnitTerm& term : equation.terms) {
    auto& value = values_[static_cast<std::size_t>(term.variable)];
    const auto unit = value->one();
    if (!unit || unit->angle != 0.0 || sum->angle + term.exponent != 0.0) continue;
    if (unit->cycles != 0.0 && sum->cycles != 0.0) continue;  // two rates of different meaning stay unchanged
    unit::Dimension rate = *unit;
    rate.exponents[2] = 0.0;
    if (rate != unit::Dimension{} || unit->exponents[2] > 0.0) continue;
    unit::Dimension turned = *unit;
    turned.angle = 1.0;
    value = turned;
    return term.variable;
  }
  return -1;
}

void UnitEquations::check_rates(const Complain& complain) {
  for (const UnitEquation& equation : equations_) {
    const auto product = dimension_of(equation);
    const auto sum = product ? product->one() : std::nullopt;
    if (sum && *sum == unit::Dimension{} && unit::mixes_rates(*sum) && !follows_from_another(equation))
      complain(equation, *sum, std::nullopt);
  }
}

void UnitEquations::restrict_elements(int variable, Elements kind) {
  kinds_.resize(std::max(kinds_.size(), static_cast<std::size_t>(variable) + 1), Elements::own);
  kinds_[static_cast<std::size_t>(variable)] = kind;
}

/// Solves for the only unknown variable and returns it. Checks an equation without unknowns. Returns -1 if no
/// variable was solved.
int UnitEquations::step(UnitEquation& equation, const Complain& complain) {
  ElementUnits known = equation.constant;
  const UnitTerm* unknown = nullptr;
  for (const UnitTerm& term : equation.terms) {
    const auto& value = values_[static_cast<std::size_t>(term.variable)];
    if (!value && unknown) return -1;
    if (value)
      known = known.times(value->elements(term.elements), term.exponent);
    else
      unknown = &term;
  }
  if (!unknown) {
    const auto wrong = known.other_than_one();
    if (wrong && !follows_from_another(equation)) report(equation, *wrong, complain);
    return -1;
  }
  if (!is_due(equation, *unknown) || (!unknown->elements.is_whole() && !known.is_one())) return -1;
  if (known.is_one() && !known.one()) return -1;
  return solve(equation, *unknown, known);
}

/// Gives the unknown of an equation the unit for which the product is 1.
int UnitEquations::solve(UnitEquation& equation, const UnitTerm& unknown, ElementUnits known) {
  const int solved = unknown.variable;
  const double exponent = unknown.exponent;
  const Elements kind = kinds_[static_cast<std::size_t>(solved)];
  if (!known.is_one() && kind == Elements::scaled) {
    equation.terms.clear();  // the factor has different units for different elements
    equation.constant = {};
    known = ElementUnits();
  } else if (!known.is_one() && kind == Elements::alike) {
    known = ElementUnits::unknown();
  }
  set_by_[static_cast<std::size_t>(solved)] = static_cast<int>(&equation - equations_.data());
  set(solved, ElementUnits().times(known, -1.0 / exponent));
  return solved;
}

/// Returns the units of a join; std::nullopt if they are not determined yet. `all_known` means that the units
/// of its pieces are final.
std::optional<ElementUnits> UnitEquations::joined(const UnitJoin& join, bool all_known) const {
  ElementUnits::Each each;
  std::optional<ElementUnits> common;
  bool differ = false, sized = true, some_unknown = false;
  for (const UnitJoin::Piece& piece : join.pieces) {
    const auto units = piece.is_bare ? std::nullopt : dimension_of(piece.unit);
    if (!units && !piece.is_bare && !all_known) return std::nullopt;
    some_unknown = some_unknown || (!units && !piece.is_bare);
    if (units && !common) common = units;
    differ = differ || (units && (!units->is_one() || !agree(*units, *common)));
    sized = sized && piece.size > 0;
    for (std::size_t k = 0; k < piece.size; ++k) each.push_back(units ? units->of(k) : std::nullopt);
  }
  if (!common) return std::nullopt;
  if (!differ && !some_unknown && common->one()) return common->one();
  return sized ? ElementUnits(std::move(each)) : ElementUnits::unknown();
}

bool UnitEquations::join_known() {
  bool any = false;
  for (const UnitJoin& join : joins_) {
    if (values_[static_cast<std::size_t>(join.variable)]) continue;
    auto units = joined(join, false);
    if (!units) continue;
    set(join.variable, std::move(*units));
    any = true;
  }
  return any;
}

bool UnitEquations::join_rest() {
  for (const UnitJoin& join : joins_) {
    if (values_[static_cast<std::size_t>(join.variable)]) continue;
    auto units = joined(join, true);
    if (!units) continue;
    set(join.variable, std::move(*units));
    return true;
  }
  return false;
}

/// Solves the equations of a later stage.
bool UnitEquations::solve_late(Stage stage, const Complain& complain) {
  bool any = false;
  stage_ = stage;
  for (UnitEquation& equation : equations_)
    if (equation.terms.size() > 0) any = step(equation, complain) >= 0 || any;
  stage_ = Stage::whole;
  return any;
}

/// Makes factors without a value in the file pure numbers, if they are the only unknowns of a product.
bool UnitEquations::assume_pure_factors() {
  bool any = false;
  const auto is_unknown = [&](int variable) { return !values_[static_cast<std::size_t>(variable)]; };
  for (const UnitEquation& product : equations_) {
    if (product.defines < 0 || !is_unknown(product.defines)) continue;
    std::vector<int> factors;
    const bool only_factors = std::ranges::all_of(product.terms, [&](const UnitTerm& term) {
      const bool is_factor = pure_factors_.contains(term.variable) && is_unknown(term.variable);
      if (is_factor) factors.push_back(term.variable);
      return is_factor || term.variable == product.defines || !is_unknown(term.variable);
    });
    for (std::size_t i = 0; only_factors && i < factors.size(); ++i) set(factors[i], unit::Dimension{});
    any = any || (only_factors && !factors.empty());
  }
  return any;
}

/// True where an equation gives its only unknown a unit at this stage.
bool UnitEquations::is_due(const UnitEquation& equation, const UnitTerm& unknown) const {
  if (equation.only_checks || equation.joins == unknown.variable) return false;
  const bool is_defined =
      defined_first_[static_cast<std::size_t>(unknown.variable)] && equation.defines != unknown.variable;
  if (!unknown.elements.is_whole()) return stage_ == Stage::elements;
  return !is_defined || stage_ != Stage::whole;
}

/// Returns the number that has given one unit to a join whose pieces are in several; nullptr without one.
const UnitEquation* UnitEquations::number_for(const UnitEquation& piece) const {
  const auto join = std::ranges::find(joins_, piece.joins, &UnitJoin::variable);
  const auto own = piece.joins < 0 || join == joins_.end() ? std::nullopt : joined(*join, false);
  if (!own || own->is_one()) return nullptr;
  int variable = piece.joins;
  for (std::size_t step = 0; step < values_.size(); ++step) {
    const int by = set_by_[static_cast<std::size_t>(variable)];
    if (by < 0) return nullptr;
    const UnitEquation& equation = equations_[static_cast<std::size_t>(by)];
    if (equation.terms.size() == 1) return &equation;
    const auto other =
        std::ranges::find_if(equation.terms, [&](const UnitTerm& term) { return term.variable != variable; });
    variable = other->variable;
  }
  return nullptr;
}

/// Reports an equation, or in place of a piece of a join the number that does not fit it.
void UnitEquations::report(const UnitEquation& equation, const unit::Dimension& wrong,
                           const Complain& complain) const {
  const UnitEquation* const number = number_for(equation);
  const auto whole = equation.joins < 0 ? std::nullopt : values_[static_cast<std::size_t>(equation.joins)];
  const auto unit = number ? values_[static_cast<std::size_t>(number->terms.front().variable)] : std::nullopt;
  const std::size_t index = place_of(equation);
  const auto given = unit && whole && agree(*unit, *whole) ? unit->of(index) : std::nullopt;
  if (!given) return complain(equation, wrong, std::nullopt);
  const unit::Dimension element = *given / wrong;
  complain(*number, element / *given, MissedElement{element, index});
}

/// Returns the index in the whole signal of the first element for which a piece does not hold.
std::size_t UnitEquations::place_of(const UnitEquation& piece) const {
  const auto product = dimension_of(piece);
  if (!product || piece.terms.empty()) return 0;
  std::size_t within = 0;
  for (std::size_t k = product->each().size(); k-- > 0;)
    if (const auto& unit = product->each()[k]; unit && *unit != unit::Dimension{}) within = k;
  return piece.terms.front().elements.first + within;
}

/// True where a variable of this equation already occurred in a reported one, and marks its variables. It
/// suppresses faults that follow from an earlier one.
bool UnitEquations::follows_from_another(const UnitEquation& equation) {
  bool known = false;
  for (const UnitTerm& term : equation.terms) {
    known = known || in_question_[static_cast<std::size_t>(term.variable)];
    in_question_[static_cast<std::size_t>(term.variable)] = true;
  }
  return known;
}

std::optional<ElementUnits> UnitEquations::dimension_of(const UnitEquation& product) const {
  ElementUnits result = product.constant;
  for (const UnitTerm& term : product.terms) {
    const auto& value = values_[static_cast<std::size_t>(term.variable)];
    if (!value) return std::nullopt;
    result = result.times(value->elements(term.elements), term.exponent);
  }
  return result;
}

}  // namespace stepwire::diagram
