#pragma once

#include <string>
#include <utility>

#include "engine/model/diagram/bindings.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// Scope of a value that a call sets during a run, in no file of the diagram.
constexpr int given_origin = -1;

/// Collects faults of the values of a diagram, with their locations in its files.
class FaultReport {
 public:
  explicit FaultReport(const Diagram& diagram) : about_(diagram) {}

  void add(const Origin& origin, std::string subject, yaml::Message message) {
    faults_.add(fault(origin, std::move(subject), std::move(message)));
  }
  yaml::Fault fault(const Origin& origin, std::string subject, yaml::Message message) const {
    if (origin.scope != given_origin) return about_.fault(origin, std::move(subject), std::move(message));
    return {{given_, origin.mark}, std::move(subject), std::move(message), {}};
  }
  /// Sets the text that messages show as the location of given_origin.
  void call_given(std::string place) { given_ = std::move(place); }
  /// Returns the file of a scope, beside which other files are searched.
  const std::string& file_of(int scope) const {
    return scope == given_origin ? given_ : about_.scopes[static_cast<std::size_t>(scope)].file;
  }
  const yaml::Faults& faults() const { return faults_; }
  yaml::Faults& faults() { return faults_; }
  const Diagram& about() const { return about_; }

 private:
  const Diagram& about_;
  std::string given_;
  yaml::Faults faults_;
};

/// FaultReport for a diagram under construction.
class Report : public FaultReport {
 public:
  explicit Report(Diagram& diagram) : FaultReport(diagram), diagram_(diagram) {}

  Diagram& diagram() { return diagram_; }
  /// Returns the texts for reading the diagram's values again.
  Bindings& bindings() { return bindings_; }

 private:
  Diagram& diagram_;
  Bindings bindings_;
};

}  // namespace stepwire::diagram
