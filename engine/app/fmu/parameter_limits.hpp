#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"

namespace stepwire::fmu {

/// The unit that stands behind a number, "mm" of "5 mm"; empty where that is SI or there is none.
std::string written_unit(const std::string& text);

/// The limits [SI] that bounds of a parameter set which are numbers; those that exclude their number are shown
/// with it, and the unit refuses it.
void limit(std::optional<double>& at_least, std::optional<double>& at_most,
           const std::vector<yaml::Entry>& bounds);

}  // namespace stepwire::fmu
