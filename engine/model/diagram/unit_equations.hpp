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

/// A power of a variable, or of some elements of it.
struct UnitTerm {
  int variable = -1;
  double exponent = 1.0;
  ElementRange elements{};
};

/// A product of powers that must be dimensionless: constant times variables.
struct UnitEquation {
  ElementUnits constant;
  std::vector<UnitTerm> terms;
  Origin origin;
  int block = -1;  ///< whose port it is about; -1: `port` is the whole name
  const char* port = "";
  int state = -1;  ///< whose initial value it is about

  std::string what;          ///< name of the source
  bool only_checks = false;  ///< gives no variable a unit

  int defines = -1;  ///< the variable of this product
  int joins = -1;    ///< the join of which it is a piece

  bool queued = true;
};

/// A signal that joins others one behind the other; they may have different units.
struct UnitJoin {
  struct Piece {
    UnitEquation unit;     ///< the product that is its unit
    bool is_bare = false;  ///< a number without a unit
    std::size_t size = 0;  ///< 0: not known
  };
  int variable = -1;
  std::vector<Piece> pieces;
};

/// Treatment of a variable whose signal has different units by element.
enum class Elements {
  own,     ///< it has a unit for each element
  scaled,  ///< its ports have different shapes, and a factor of another variable takes up the units
  alike    ///< its ports have different shapes, so that its unit is unknown then
};

/// Equations of which each that has one unknown unit left gives that unit, and each that has none must hold.
///
/// First all is solved that follows from whole signals, then products get the units of what they feed. A join
/// gets the units of its pieces: one for all where they agree, else one for each element. Last, a signal of
/// which only an element has a unit gets that unit. Each of these stages is followed by the first one.
class UnitEquations {
 public:
  /// `complain` gets an equation that does not hold, and what its product is in; where the dimensions are
  /// equal, an angle per time meets a frequency.
  using Complain = std::function<void(const UnitEquation& equation, const unit::Dimension& wrong)>;

  void add(UnitEquation equation, std::string what);
  void add(UnitJoin join) { joins_.push_back(std::move(join)); }
  void restrict_elements(int variable, Elements kind);
  /// Lets other equations than the one that defines a variable give it a unit only where nothing else does.
  void define_first(int variable) { defined_.push_back(variable); }
  /// Notes the unit of a factor that no file gives: by default it is a pure number.
  void assume_pure(int variable) { pure_factors_.insert(variable); }
  /// For the variables 0 to `variables` - 1.
  void solve(std::size_t variables, const Complain& complain);
  /// Of the product as far as it is solved; nothing where a variable is unknown.
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
  void find_angles();
  int turn_to_angle(const UnitEquation& equation);
  void check_rates(const Complain& complain);

  std::vector<UnitEquation> equations_;
  std::vector<UnitJoin> joins_;
  std::vector<std::optional<ElementUnits>> values_;  ///< of the variables
  std::vector<std::vector<int>> users_;              ///< the equations in which each variable is
  std::deque<int> queue_;
  std::vector<bool> in_question_;
  std::vector<Elements> kinds_;  ///< of the variables
  std::vector<int> defined_;
  std::set<int> pure_factors_;
  std::vector<bool> defined_first_;
  Stage stage_ = Stage::whole;
};

}  // namespace stepwire::diagram
