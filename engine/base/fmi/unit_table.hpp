#pragma once

#include <map>
#include <string>

namespace stepwire::fmi {

/// A unit that a description defines, as a port has it.
struct ScaledUnit {
  std::string name = "*";  ///< the SI unit, or "*" where it is not known
  double factor = 1.0, offset = 0.0;  ///< value_si = offset + factor * value
};

/// Units of a description by their names.
using UnitTable = std::map<std::string, ScaledUnit>;

/// Exponents of a BaseUnit, by the names of its attributes: kg, m, s, A, K, mol, cd, rad.
using BaseExponents = std::map<std::string, int>;

/// The unit that a product of base units is.
ScaledUnit base_unit(const BaseExponents& exponents, double factor, double offset);

/// A unit of which only its name is known: what our own units make of it, or any.
ScaledUnit named_unit(const std::string& name);

}  // namespace stepwire::fmi
