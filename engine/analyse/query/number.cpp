#include "engine/analyse/query/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "engine/base/unit/meaning.hpp"
#include "engine/model/diagram/bare_number.hpp"

namespace stepwire::query {
namespace {

std::string unit_phrase(const unit::Dimension& dimension) {
  return dimension == unit::Dimension{} ? "has no unit" : "is in " + unit::si_name(dimension);
}

/// Returns the message for a percentage beside an angle; empty for other numbers.
std::string share_of_angle(const WantedNumber& number, const unit::Dimension& dimension,
                           const std::string& what) {
  const bool differ = number.unit == "%" && dimension == unit::Dimension{} && dimension.angle != 0.0;
  return differ ? fmt::format("{} is a share, but {} is an angle; write it in deg or rad", number.text, what)
                : "";
}

/// Returns the message for a number whose unit cannot be compared with `what`; empty if it can.
std::string number_fault(const WantedNumber& number, const MeantUnit& meant, const std::string& what) {
  const unit::Dimension& dimension = *meant.dimension;
  if (*number.dimension != dimension || (meant.is_ratio && number.dimension->angle != 0.0)) {
    const bool is_named = *number.dimension == unit::Dimension{} && !number.unit.empty();  // deg, %
    const std::string wanted =
        dimension == unit::Dimension{} ? "a number without unit" : unit::si_name(dimension);
    return fmt::format("{} {}, but {} {}; write {}{}", number.text,
                       is_named ? "is in " + number.unit : unit_phrase(*number.dimension), what,
                       unit_phrase(dimension), dimension == unit::Dimension{} ? "" : "it in ", wanted);
  }
  if (std::string share = share_of_angle(number, dimension, what); !share.empty()) return share;
  std::string other = unit::other_meaning_of_number(*number.dimension, dimension);
  if (!other.empty()) return fmt::format("{} {}", number.text, other);
  other = unit::other_meaning(dimension, *number.dimension);
  return other.empty() ? "" : fmt::format("{} {}", what, other);
}

/// Returns degC or degF for the text of a parameter, $wall, that the file gives in it; empty for others.
std::string unit_of_temperature(const std::string& text, const SymbolTable& names) {
  const std::string name = text.starts_with('$') ? text.substr(1) : text;
  const auto found = std::ranges::find(names.parameters, name, &KnownParameter::name);
  const auto unit = found == names.parameters.end() ? std::nullopt : unit::parse_unit(found->unit);
  return unit && unit->offset != 0.0L ? found->unit : "";
}

/// Returns the word behind a number that is no unit: "foo" of "1 foo"; empty for formulas.
std::string wrong_unit(const std::string& text) {
  const std::string word = unit_after_number(text);
  const bool is_word = !word.empty() && word.size() < text.size() &&
                       std::isalpha(static_cast<unsigned char>(word[0])) &&
                       std::ranges::all_of(word, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  return is_word && !unit::parse_unit(word) ? word : "";
}

}  // namespace

std::string unit_after_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  std::string unit(end);
  unit.erase(0, std::min(unit.find_first_not_of(' '), unit.size()));
  return unit;
}

std::string compared_fault(const Formula& first, const Formula& second) {
  const auto &one = first.dimension, &two = second.dimension;
  if (!one || !two) return "";
  if (*one != *two)
    return fmt::format("'{}' is in {}, but '{}' is in {}", first.text, unit::si_name(*one), second.text,
                       unit::si_name(*two));
  const std::string cure = unit::mixes_rates(*one / *two) ? "; " + unit::cure_of_rate(*one, *two) : "";
  std::string other = unit::other_meaning(*one, *two);
  if (!other.empty()) return fmt::format("'{}' {}{}", first.text, other, cure);
  other = unit::other_meaning(*two, *one);
  return other.empty() ? "" : fmt::format("'{}' {}", second.text, other);
}

std::optional<WantedNumber> read_number(const yaml::Node& node, const SymbolTable& names,
                                        const std::string& subject, yaml::Faults& faults) {
  if (node.is_scalar()) {
    if (const auto quantity = unit::parse_quantity(node.text))
      return WantedNumber{quantity->value, quantity->dimension, unit_after_number(node.text), node.text};
  } else {
    faults.add({{names.file, node.mark}, subject, "a number is wanted here, such as '2 N'", {}});
    return std::nullopt;
  }
  if (const std::string unit = wrong_unit(node.text); !unit.empty()) {
    faults.add({{names.file, node.mark}, subject, fmt::format("'{}' is no unit", unit), {}});
    return std::nullopt;
  }
  const auto formula = read_formula(node, names, subject, faults);
  if (!formula) return std::nullopt;
  if (!formula->columns.empty()) {
    const auto& name = formula->expression.variables().front();
    faults.add({place_in(node, node.text.find(name), names),
                subject,
                fmt::format("a number is wanted here, but '{}' is a recorded column", name),
                {}});
    return std::nullopt;
  }
  const bool is_temperature = formula->dimension && formula->dimension->zeros;
  return WantedNumber{formula->expression({}), is_temperature ? formula->dimension : std::nullopt,
                      unit_of_temperature(formula->text, names), formula->text};
}

void check_dimension(const WantedNumber& number, const MeantUnit& meant, const std::string& what,
                     const yaml::Node& node, const SymbolTable& names, const std::string& subject,
                     yaml::Faults& faults) {
  if (!number.dimension || !meant.dimension) return;
  const std::string fault = number_fault(number, meant, what);
  if (!fault.empty()) faults.add({{names.file, node.mark}, subject, fault, {}});
}

std::optional<yaml::Message> bare_number(const std::string& text, const std::string& unit,
                                         const std::string& what) {
  return diagram::bare_number(text, unit, what);
}

std::string read_text(const yaml::Node& node, const SymbolTable& names, const std::string& subject,
                      yaml::Faults& faults) {
  if (node.is_scalar() && !node.text.empty()) return node.text;
  faults.add({{names.file, node.mark}, subject, "a text is wanted here", {}});
  return {};
}

double rounded(double value, int digits) {
  const std::string text = fmt::format("{:.{}g}", value, digits);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string short_number(double value, int digits) {
  constexpr double most_whole = 1e15;   // all digits of a double fit
  if (value == 0.0) return "0";         // also -0
  if (std::isnan(value)) return "nan";  // without the sign that a NaN may have
  if (std::abs(value) < most_whole && value == std::trunc(value)) return fmt::format("{:.0f}", value);
  return fmt::format("{:.{}g}", value, digits);
}

}  // namespace stepwire::query
