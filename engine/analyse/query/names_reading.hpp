#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/formula.hpp"
#include "engine/base/yaml/section.hpp"

namespace stepwire::query {

struct Series;

/// Context for reading sections about recorded signals: figures, claims, scenes, fits.
struct NamesReading : yaml::SectionReading {
  const SymbolTable& names;
  yaml::Faults& faults;

  NamesReading(std::string subject, const SymbolTable& names, yaml::Faults& faults)
      : yaml::SectionReading(std::move(subject),
                             [file = names.file, &faults](const yaml::Mark& mark, const std::string& about,
                                                          const yaml::Message& message) {
                               faults.add({{file, mark}, about, message, {}});
                             }),
        names(names),
        faults(faults) {}

  using yaml::SectionReading::take;
  void take(const yaml::Node& node, const yaml::Key& key, std::optional<Formula>& formula) const;
  void take(const yaml::Node& node, const yaml::Key& key, std::optional<Series>& series) const;
  /// Reads one expression with a unit, or a list of them.
  void take(const yaml::Node& node, const yaml::Key& key, std::vector<Series>& series) const;
  /// Reads two numbers in the unit of the key, the smaller one first.
  void take(const yaml::Node& node, const yaml::Key& key, std::array<double, 2>& range) const;

  std::optional<Formula> formula(const yaml::Node& node) const;
  std::optional<Series> series(const yaml::Node& node) const;

 protected:
  /// Reads a number in the unit of the key: an expression of numbers and `$name`.
  std::optional<double> read_number(const yaml::Node& node, const yaml::Key& key) const override;
};

/// Returns the schema of a series: an expression, or a map with it and its label.
const yaml::Key& series_form();
inline constexpr std::size_t max_coordinates = 3;  ///< of one place

/// Reads an expression for a length. A bare number is in metres.
std::optional<Formula> read_length(const yaml::Node& node, const SymbolTable& names,
                                   const std::string& subject, yaml::Faults& faults);

/// Reads a place of one to three coordinates: [x, y], or the name of a recorded vector (rig.position). Adds a
/// fault and returns an empty list for anything else.
std::vector<Formula> read_place(const yaml::Node& node, const SymbolTable& names, const std::string& subject,
                                yaml::Faults& faults);

}  // namespace stepwire::query
