#include "engine/model/diagram/bindings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

namespace {

template <class Check>
bool all_of_numbers(const Value& value, const Check& check) {
  if (const auto* number = std::get_if<double>(&value.content)) return check(*number);
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
    return std::all_of(vector->begin(), vector->end(), check);
  const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content);
  return !matrix || std::all_of(matrix->data(), matrix->data() + matrix->size(), check);
}

bool holds(const std::string& bound, double number, double limit) {
  if (bound == "above") return number > limit;
  if (bound == "at_least") return number >= limit;
  return bound == "below" ? number < limit : number <= limit;
}

/// Returns the words of a bound, "at least" for "at_least".
std::string words_of(std::string bound) {
  std::replace(bound.begin(), bound.end(), '_', ' ');
  return bound;
}

/// Checks of values of one definition.
class Acceptance {
 public:
  Acceptance(const Definition& definition, const ParameterScope& scope, const std::string& full_name,
             ParameterUses& uses, FaultReport& report)
      : definition_(definition), scope_(scope), full_name_(full_name), uses_(uses), report_(report) {}

  void check_unit(WrittenValue& value, const Origin& origin) {
    const bool is_bare = !value.dimension && value.each.empty();
    const std::string fault = is_bare                    ? ""
                              : definition_.each.empty() ? unit_fault(value, definition_.dimension)
                                                         : each_fault(value);
    if (!fault.empty()) report_.add(origin, full_name_, fault);
    if (is_bare || !fault.empty()) take_units(value);  // prevents the same fault at all its uses
  }

  bool in_bounds(const WrittenValue& value, const Origin& origin) {
    return std::all_of(definition_.bounds.begin(), definition_.bounds.end(), [&](const yaml::Entry& bound) {
      const auto limit = read(bound, value);
      if (!limit) return false;
      if (all_of_numbers(value.value, [&](double number) { return holds(bound.key, number, *limit); }))
        return true;
      report_.add(origin, full_name_,
                  yaml::fault_text("{} is not allowed; it must be {} {}", value.text, words_of(bound.key),
                                   bound.value.text));
      return false;
    });
  }

 private:
  static std::size_t size_of(const WrittenValue& value) {
    if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.value.content))
      return static_cast<std::size_t>(vector->size());
    const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.value.content);
    return matrix ? static_cast<std::size_t>(matrix->size()) : 1;
  }

  /// Gives a value the units of the definition.
  void take_units(WrittenValue& value) const {
    value.dimension = definition_.dimension;
    const bool has_size = size_of(value) == definition_.each.size();
    value.each = has_size ? definition_.each : EachUnit{};
  }

  /// Returns the fault of a value with units where the definition has several; empty if they agree.
  std::string each_fault(const WrittenValue& value) const {
    const EachUnit& demanded = definition_.each;
    if (size_of(value) != demanded.size())
      return fmt::format("{} must have {} elements, since the file gives one unit for each", value.text,
                         demanded.size());
    for (std::size_t k = 0; k < demanded.size(); ++k)
      if (const std::string complaint =
              unit_complaint(value.each.empty() ? value.dimension : value.each[k], demanded[k]);
          !complaint.empty())
        return fmt::format("element {} of {} {}", k + 1, value.text, complaint);
    return "";
  }

  std::optional<double> read(const yaml::Entry& bound, const WrittenValue& value) {
    const std::string subject = full_name_ + "." + bound.key;
    const auto limit = ValueReader(scope_, report_, definition_.scope, &uses_).read(bound.value, subject);
    if (!limit) return std::nullopt;
    const double* number = std::get_if<double>(&limit->value.content);
    const auto wrong = wrong_element(value.each, limit->dimension);
    const std::string complaint =
        number ? unit_complaint(limit->dimension, wrong ? value.each[*wrong] : value.dimension)
               : std::string("is no number, and a bound is one");
    if (complaint.empty()) return *number;
    report_.add({definition_.scope, bound.value.mark}, subject,
                fmt::format("'{}' {}", limit->text, complaint));
    return std::nullopt;
  }

  const Definition& definition_;
  const ParameterScope& scope_;
  const std::string& full_name_;
  ParameterUses& uses_;
  FaultReport& report_;
};

}  // namespace

const std::vector<std::string> bound_keys = {"above", "at_least", "below", "at_most"};

void note_giver(WrittenValue& value, const Definition& definition, const std::string& full_name,
                const Origin& origin) {
  if (!value.value.text() && !std::holds_alternative<Value::List>(value.value.content)) return;
  const unit::Dimension dimension = definition.dimension.value_or(unit::Dimension{});
  value.given = {origin, full_name, dimension == unit::Dimension{} ? "" : " " + unit::si_name(dimension)};
}

bool accepts(const Definition& definition, const ParameterScope& scope, WrittenValue& value,
             const Origin& origin, const std::string& full_name, ParameterUses& uses, FaultReport& report) {
  Acceptance acceptance(definition, scope, full_name, uses, report);
  acceptance.check_unit(value, origin);
  return acceptance.in_bounds(value, origin);
}

}  // namespace stepwire::diagram
