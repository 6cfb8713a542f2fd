#pragma once

#include <string>
#include <utility>

#include "engine/model/diagram/bindings.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// The scope of a value that a call gives while the diagram is there, in no file of it.
constexpr int given_origin = -1;

/// Gathers what is wrong with values of a diagram, with the places of its files.
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
  /// What is named as the place of given_origin from now on.
  void call_given(std::string place) { given_ = std::move(place); }
  /// The file of a scope, beside which files are looked for.
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

/// The same while a diagram is built.
class Report : public FaultReport {
 public:
  explicit Report(Diagram& diagram) : FaultReport(diagram), diagram_(diagram) {}

  Diagram& diagram() { return diagram_; }
  /// How the diagram's values are read again.
  Bindings& bindings() { return bindings_; }

 private:
  Diagram& diagram_;
  Bindings bindings_;
};

}  // namespace stepwire::diagram
