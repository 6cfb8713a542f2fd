#pragma once

#include <optional>
#include <string>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/message.hpp"

namespace stepwire::diagram {

/// A number and its unit as written: "5 mm" is {5, "mm"}.
struct WrittenNumber {
  double number = 0.0;
  std::string unit;
};
std::optional<WrittenNumber> written_number(const yaml::Node& node);

/// True for a unit whose numbers are not those of SI. A percent is a number.
bool is_scaled(const std::string& unit);

/// True for a number that is written without unit. 0 and infinity need none.
bool is_bare(const yaml::Node& node);

/// Returns the unit behind a number, or behind the first number of a list that has one; empty without one.
std::string unit_as_written(const yaml::Node& node);

/// Returns the fault of a number written without unit where `what` is in a unit other than SI; std::nullopt
/// for 0, infinity, percent and other texts, such as formulas.
std::optional<yaml::Message> bare_number(const std::string& text, const std::string& unit,
                                         const std::string& what);

/// Returns the fault of a number without unit beside one in a unit other than SI, as of 2 in [1 mm, 2].
/// `place` gets the number. Returns std::nullopt for lists in units of several dimensions, and other nodes.
std::optional<yaml::Message> bare_element(const yaml::Node& list, const yaml::Node*& place);

}  // namespace stepwire::diagram
