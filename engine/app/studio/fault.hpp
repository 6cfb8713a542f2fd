#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "engine/base/json/json.hpp"

namespace stepwire::studio {

/// Reason for the refusal of a call: "what is wrong; what would be right".
class Fault : public std::runtime_error {
 public:
  /// `more` is an object whose members are sent to the page beside the text.
  explicit Fault(const std::string& text, json::Json more = json::Json::object())
      : std::runtime_error(text), more_(std::move(more)) {}

  const json::Json& more() const { return more_; }

 private:
  json::Json more_;
};

/// Returns the member `fault` of an answer for the exception being handled: {text, cure, faults}.
json::Json fault_in_flight();

}  // namespace stepwire::studio
