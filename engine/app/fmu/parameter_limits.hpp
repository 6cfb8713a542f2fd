#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"

namespace stepwire::fmu {

/// Returns the unit in the text of a number, "mm" of "5 mm"; empty for an SI unit or a pure number.
std::string written_unit(const std::string& text);

/// Writes the numeric bounds of a parameter in SI. An excluded bound is written like an included one; the
/// unit refuses the bound itself.
void limit(std::optional<double>& at_least, std::optional<double>& at_most,
           const std::vector<yaml::Entry>& bounds);

}  // namespace stepwire::fmu
