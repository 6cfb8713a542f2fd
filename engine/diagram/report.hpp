#pragma once

#include <string>
#include <utility>

#include "engine/diagram/diagram.hpp"

namespace stepwire {

/// Gathers what is wrong while a diagram is built, with the places of its files.
class Report {
 public:
  explicit Report(Diagram& diagram) : diagram_(diagram) {}

  void add(const Origin& origin, std::string subject, std::string message) {
    faults_.add(diagram_.fault(origin, std::move(subject), std::move(message)));
  }
  const Faults& faults() const { return faults_; }
  Diagram& diagram() { return diagram_; }

 private:
  Diagram& diagram_;
  Faults faults_;
};

}  // namespace stepwire
