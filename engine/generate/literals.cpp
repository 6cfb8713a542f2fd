#include "engine/generate/literals.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stepwire {

std::string number_text(double value) {
  if (std::isnan(value)) return "std::numeric_limits<double>::quiet_NaN()";
  if (std::isinf(value)) return value > 0.0 ? "unlimited" : "-unlimited";
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string Literals::parameter(double value) {
  all_.push_back(value);
  return varies(all_.size() - 1) ? fmt::format("parameters[{}]", all_.size() - 1) : "";
}

std::string Literals::number(double value) {
  const std::string place = parameter(value);
  return place.empty() ? number_text(value) : place;
}

std::string Literals::flag(bool value) {
  const std::string place = parameter(value ? 1.0 : 0.0);
  if (!place.empty()) return place + " != 0.0";
  return value ? "true" : "false";
}

std::string Literals::enumerator(int value, const std::string& type) {
  const std::string place = parameter(value);
  const std::string number =
      place.empty() ? std::to_string(value) : fmt::format("static_cast<int>({})", place);
  return fmt::format("static_cast<{}>({})", type, number);
}

std::string Literals::count(Index count) {
  if (!stands_apart(count)) return std::to_string(count);
  const std::string place = parameter(static_cast<double>(count));
  return place.empty() ? std::to_string(count) : fmt::format("static_cast<Index>({})", place);
}

std::string Literals::put_apart(const double* values, Index size) {
  places_.push_back(all_.size());
  all_.push_back(static_cast<double>(apart_.size()));
  apart_.insert(apart_.end(), values, values + size);
  return fmt::format("parameters + static_cast<Index>(parameters[{}])", places_.back());
}

std::vector<double> Literals::all() const {
  std::vector<double> all = all_;
  for (std::size_t place : places_) all[place] += static_cast<double>(all_.size());
  all.insert(all.end(), apart_.begin(), apart_.end());
  return all;
}

std::string Literals::numbers(const double* values, Index size) {
  if (stands_apart(size)) return put_apart(values, size);
  const std::size_t first = all_.size();
  all_.insert(all_.end(), values, values + size);
  for (std::size_t i = first; i < all_.size(); ++i)
    if (varies(i)) return fmt::format("parameters + {}", first);
  const std::string name = in_name_++ == 0 ? name_ : fmt::format("{}_{}", name_, in_name_);
  tables_ += fmt::format("constexpr double {}[] = {{", name);
  for (Index i = 0; i < size; ++i)
    tables_ += fmt::format("{}{}", i == 0 ? "" : i % 8 == 0 ? ",\n    " : ", ", number_text(values[i]));
  tables_ += "};\n";
  return "table::" + name;
}

}  // namespace stepwire
