#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/diagram/diagram.hpp"
#include "engine/model/diagram/element_units.hpp"

namespace stepwire::diagram {

/// A power of a variable, or of some of its elements.
struct UnitTerm {
  int variable = -1;
  double exponent = 1.0;
  ElementRange elements{};
};

/// Equation: the product of a constant and powers of variables is dimensionless.
struct UnitEquation {
  ElementUnits constant;
  std::vector<UnitTerm> terms;
  Origin origin;
  int block = -1;  ///< of the port concerned; -1: `port` is the whole name
  const char* port = "";
  int state = -1;  ///< whose initial value is concerned

  std::string what;          ///< name of the source
  bool only_checks = false;  ///< determines no variable

  int defines = -1;  ///< variable of this product
  int joins = -1;    ///< join of which it is a piece

  bool queued = true;
};

/// A signal that concatenates others, possibly of different units.
struct UnitJoin {
  struct Piece {
    UnitEquation unit;     ///< product that is its unit
    bool is_bare = false;  ///< a number without a unit
    std::size_t size = 0;  ///< 0: unknown
  };
  int variable = -1;
  std::vector<Piece> pieces;
};

/// Treatment of a variable whose signal has different units by element.
enum class Elements {
  own,     ///< one unit for each element
  scaled,  ///< its ports have different shapes, and a factor of another variable absorbs the differences
  alike    ///< its ports have different shapes, so that different units make it unknown
};

/// Element of a port to which one of several numbers, or one number for all, does not fit.
struct MissedElement {
  unit::Dimension unit;
  std::size_t index = 0;
};

/// System of unit equations. An equation with one unknown unit determines it; one without unknowns is
/// checked.
///
/// Solving has stages. First come all equations of whole signals, then products get the units of the inputs
/// that read them. A join gets the units of its pieces: one for all if they agree, else one for each element.
/// Last, a signal with a unit for one element only gets that unit. Each of the later stages is followed by
/// the first one.
class UnitEquations {
 public:
  /// Callback for an equation that does not hold; `wrong` is the unit of its product. For equal dimensions an
  /// angle per time meets a frequency. `element` is an element of the port where a number has given its unit
  /// to elements of other units; else std::nullopt.
  using Complain = std::function<void(const UnitEquation& equation, const unit::Dimension& wrong,
                                      const std::optional<MissedElement>& element)>;

  void add(UnitEquation equation, std::string what);
  void add(UnitJoin join) { joins_.push_back(std::move(join)); }
  void restrict_elements(int variable, Elements kind);
  /// Lets other equations than the defining one determine a variable only as a last resort.
  void define_first(int variable) { defined_.push_back(variable); }
  /// Records a factor without a value in the file; by default it is a pure number.
  void assume_pure(int variable) { pure_factors_.insert(variable); }
  /// Solves for the variables 0 to `variables` - 1.
  void solve(std::size_t variables, const Complain& complain);
  /// Returns the unit of a product; std::nullopt if one of its variables is unknown.
  std::optional<ElementUnits> dimension_of(const UnitEquation& product) const;

 private:
  enum class Stage { whole, products, elements };

  void find_users();
  void drain(const Complain& complain);
  int step(UnitEquation& equation, const Complain& complain);
  int solve(UnitEquation& equation, const UnitTerm& unknown, ElementUnits known);
  void set(int variable, ElementUnits units);
  bool join_known();
  bool join_rest();
  bool assume_pure_factors();
  bool solve_late(Stage stage, const Complain& complain);
  bool is_due(const UnitEquation& equation, const UnitTerm& unknown) const;
  std::optional<ElementUnits> joined(const UnitJoin& join, bool all_known) const;
  bool follows_from_another(const UnitEquation& equation);
  const UnitEquation* number_for(const UnitEquation& piece) const;
  void report(const UnitEquation& equation, const unit::Dimension& wrong, const Complain& complain) const;
  std::size_t place_of(const UnitEquation& piece) const;
  void find_angles();
  int turn_to_angle(const UnitEquation& equation);
  void check_rates(const Complain& complain);

  std::vector<UnitEquation> equations_;
  std::vector<UnitJoin> joins_;
  std::vector<std::optional<ElementUnits>> values_;  ///< of the variables
  std::vector<int> set_by_;                          ///< equation that determined a variable; -1: none
  std::vector<std::vector<int>> users_;              ///< equations of each variable
  std::deque<int> queue_;
  std::vector<bool> in_question_;
  std::vector<Elements> kinds_;  ///< of the variables
  std::vector<int> defined_;
  std::set<int> pure_factors_;
  std::vector<bool> defined_first_;
  Stage stage_ = Stage::whole;
};

}  // namespace stepwire::diagram
