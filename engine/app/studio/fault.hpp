#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "engine/base/json/json.hpp"

namespace stepwire::studio {

/// Why a call of the page is refused: "what is wrong; what would be right".
class Fault : public std::runtime_error {
 public:
  /// `more` is an object whose members go to the page beside the text.
  explicit Fault(const std::string& text, json::Json more = json::Json::object())
      : std::runtime_error(text), more_(std::move(more)) {}

  const json::Json& more() const { return more_; }

 private:
  json::Json more_;
};

/// The member `fault` of an answer, of whatever was thrown and is being handled: {text, cure, faults}.
json::Json fault_in_flight();

}  // namespace stepwire::studio
