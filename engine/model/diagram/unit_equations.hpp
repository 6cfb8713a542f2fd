#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// A product of powers that must be dimensionless: constant times variables.
struct UnitEquation {
  unit::Dimension constant;
  std::vector<std::pair<int, double>> terms;
  Origin origin;
  int block = -1;  ///< whose port it is about, -1: `port` holds the name
  const char* port = "";
  int state = -1;    ///< whose initial value it is about, where it is
  std::string what;  ///< what is wired or written there
  bool queued = true;
};

/// Equations of which each that has one unknown unit left gives that unit, and each that has none must hold.
class UnitEquations {
 public:
  /// `complain` gets an equation that does not hold, and what its product is in.
  using Complain = std::function<void(const UnitEquation& equation, const unit::Dimension& wrong)>;

  void add(UnitEquation equation, std::string what);
  /// For the variables 0 to `variables` - 1.
  void solve(std::size_t variables, const Complain& complain);
  /// Of the product as far as it is solved; nothing where a variable is unknown.
  std::optional<unit::Dimension> dimension_of(const UnitEquation& product) const;

 private:
  std::vector<std::vector<int>> users() const;
  int step(const UnitEquation& equation, const Complain& complain);
  bool follows_from_another(const UnitEquation& equation);
  void find_angles();
  int turn_to_angle(const UnitEquation& equation);

  std::vector<UnitEquation> equations_;
  std::vector<std::optional<unit::Dimension>> values_;  ///< of the variables
  std::vector<bool> in_question_;
};

}  // namespace stepwire::diagram
