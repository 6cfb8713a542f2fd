#pragma once

#include <optional>
#include <string>

#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/unit_equations.hpp"

namespace stepwire::diagram {

/// Reports unit equations that do not hold.
class UnitFaults {
 public:
  explicit UnitFaults(Report& report) : report_(report) {}

  /// `wrong` is the unit of the product, `taken` the unit of the port if known.
  void add(const UnitEquation& equation, const unit::Dimension& wrong,
           const std::optional<unit::Dimension>& taken);
  /// Reports number `element` of several, counted from 0. `wrong` is the ratio of the units of port and
  /// number, `taken` the unit of the port's element if known.
  void add_element(const UnitEquation& equation, std::size_t element, const unit::Dimension& wrong,
                   const std::optional<unit::Dimension>& taken);
  /// Reports one number for a signal whose elements are in several units; `element` is the unit of one of
  /// them, and `wrong` its ratio to that of the number.
  void add_number(const UnitEquation& equation, const unit::Dimension& wrong, const unit::Dimension& element);
  /// Returns the unit that a port of a part or the section `units` demands.
  std::optional<unit::Dimension> demanded(const UnitEquation& equation) const;
  std::string name_of(const Source& source) const;

 private:
  const DiagramBlock& block(int index) const;
  std::string subject_of(const UnitEquation& equation) const;

  Report& report_;
};

}  // namespace stepwire::diagram
