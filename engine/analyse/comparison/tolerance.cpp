#include "engine/analyse/comparison/tolerance.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <cmath>
#include <filesystem>

#include "engine/base/yaml/section.hpp"

namespace stepwire::comparison {

namespace {

using yaml::form;
using Rows = yaml::KeyTable<Tolerance, yaml::SectionReading>;

template <class Value>
void override(std::optional<Value>& value, const std::optional<Value>& other) {
  if (other) value = other;
}

void override(Tolerance& tolerance, const Tolerance& other) {
  if (other.absolute) {
    tolerance.absolute = other.absolute;
    tolerance.unit = other.unit;
    tolerance.absolute_text = other.absolute_text;
  }
  override(tolerance.relative, other.relative);
  override(tolerance.jitter, other.jitter);
  override(tolerance.hold, other.hold);
}

using SetText = std::string (*)(Tolerance& tolerance, const std::string& text);

/// Makes the row of a key whose text one of the functions above reads.
Rows::Row text_row(std::string name, std::string doc, SetText set) {
  return {std::move(name), std::move(doc), form::text(),
          [set](Tolerance& tolerance, const yaml::Node& node, const yaml::SectionReading& read) {
            const std::string fault = set(tolerance, read.text(node));
            if (!fault.empty()) read.fault(node.mark, fault);
          }};
}

const Rows& tolerance_keys() {
  static const Rows table(
      "a tolerance", "{absolute: 0.1 N, relative: 1 %, jitter: 2 ms}",
      {text_row("absolute", "accepted difference in the unit of the signal", set_absolute),
       text_row("relative", "accepted share of the largest absolute value in A", set_relative),
       text_row("jitter", "time by which an edge may be earlier or later", set_jitter),
       {"hold", "true: B keeps each value up to the next row; false: straight lines between rows",
        form::truth(), [](Tolerance& tolerance, const yaml::Node& node, const yaml::SectionReading& read) {
          if (const auto index = read.word(node, form::truth())) tolerance.hold = *index == 1;
        }}});
  return table;
}

using AcceptanceRows = yaml::KeyTable<Acceptance, yaml::SectionReading>;

void read_rules(Acceptance& acceptance, const yaml::Node& node, const yaml::SectionReading& read) {
  if (!node.is_map()) return read.fault(node.mark, "is a map: {\"*\": {relative: 1 %}}");
  for (const yaml::Entry& entry : node.entries) {
    ToleranceRule rule{entry.key, {}};
    tolerance_keys().read(entry.value, rule.tolerance, yaml::below(read, entry.key));
    acceptance.tolerances.rules.push_back(std::move(rule));
  }
}

void read_only(Acceptance& acceptance, const yaml::Node& node, const yaml::SectionReading& read) {
  for (const yaml::Node& item : node.as_list()) acceptance.tolerances.only.push_back(read.text(item));
}

const AcceptanceRows& acceptance_keys() {
  static const AcceptanceRows table(
      "a file of accepted differences", "{baseline: baseline.csv, signals: {\"*\": {relative: 1 %}}}",
      {{"baseline", "file or folder of a run that is A, from the folder of this file", form::string(),
        &Acceptance::baseline},
       {"signals", "tolerances by name, where * stands for any text; later ones win, key by key",
        form::names(tolerance_keys().form), read_rules},
       {"only", "names of the signals that are compared; without it all are", form::one_or_list(form::text()),
        read_only}});
  return table;
}

}  // namespace

Tolerance Tolerances::of(const std::string& signal) const {
  Tolerance found;
  for (const ToleranceRule& rule : rules)
    if (matches(rule.signals, signal)) override(found, rule.tolerance);
  return found;
}

bool Tolerances::includes(const std::string& signal) const {
  bool any = only.empty();
  for (const std::string& pattern : only) any = any || matches(pattern, signal);
  return any;
}

bool matches(const std::string& pattern, const std::string& name) {
  return pattern == name || ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::string set_absolute(Tolerance& tolerance, const std::string& text) {
  const auto number = unit::parse_quantity(text);
  if (!number || number->value < 0.0)
    return fmt::format("'{}' is no tolerance; write a number of 0 or more with the unit of the signal, 0.1 N",
                       text);
  if (number->dimension && number->dimension->zeros.value_or(0.0) != 0.0)
    return fmt::format("{} is a temperature and no difference of two; write it in K", text);
  tolerance.absolute = number->value;
  tolerance.unit = number->dimension;
  tolerance.absolute_text = text;
  return "";
}

std::string set_relative(Tolerance& tolerance, const std::string& text) {
  const auto number = unit::parse_quantity(text);
  const bool is_share =
      number && number->value >= 0.0 && (!number->dimension || *number->dimension == unit::Dimension{});
  if (!is_share) return fmt::format("'{}' is no share; write one of 0 or more, 1 % or 0.01", text);
  tolerance.relative = number->value;
  return "";
}

std::string set_jitter(Tolerance& tolerance, const std::string& text) {
  const auto number = unit::parse_quantity(text);
  const bool is_time =
      number && number->value >= 0.0 && number->dimension == unit::parse_unit("s")->dimension;
  if (!is_time) return fmt::format("'{}' is no time; write one of 0 or more with its unit, 2 ms", text);
  tolerance.jitter = number->value;
  return "";
}

Acceptance read_acceptance(const std::string& file) {
  const yaml::Document document = yaml::read_document(file);
  yaml::Faults faults;
  const yaml::SectionReading read(
      "", [&](const yaml::Mark& mark, const std::string& subject, const yaml::Message& message) {
        faults.add({{file, mark}, subject, message, {}});
      });
  Acceptance acceptance;
  acceptance_keys().read(document.root, acceptance, read);
  faults.throw_if_any();
  if (!acceptance.baseline.empty())
    acceptance.baseline =
        (std::filesystem::path(file).parent_path() / acceptance.baseline).lexically_normal().string();
  return acceptance;
}

}  // namespace stepwire::comparison
