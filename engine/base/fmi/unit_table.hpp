#pragma once

#include <map>
#include <string>

namespace stepwire::fmi {

/// A unit of a description, converted to the unit of a port.
struct ScaledUnit {
  std::string name = "*";  ///< the SI unit, or "*" if unknown
  double factor = 1.0, offset = 0.0;  ///< value_si = offset + factor * value
};

/// Units of a description by their names.
using UnitTable = std::map<std::string, ScaledUnit>;

/// Exponents of a BaseUnit, by the names of its attributes: kg, m, s, A, K, mol, cd, rad.
using BaseExponents = std::map<std::string, int>;

/// Returns the unit of a product of base units.
ScaledUnit base_unit(const BaseExponents& exponents, double factor, double offset);

/// Returns the unit of a bare unit name: an SI unit that our own export writes, or unknown.
ScaledUnit named_unit(const std::string& name);

}  // namespace stepwire::fmi
