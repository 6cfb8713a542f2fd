#include "engine/simulate/codegen/literals.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stepwire::codegen {

std::string number_text(double value) {
  if (std::isnan(value)) return "std::numeric_limits<double>::quiet_NaN()";
  if (std::isinf(value)) return value > 0.0 ? "unlimited" : "-unlimited";
  std::string text = fmt::format(FMT_COMPILE("{}"), value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string Literals::next() {
  return fmt::format("{}[{}]", table_, count_++);
}

bool Literals::varies() {
  const std::size_t item = item_++;
  return item < items_.size() && items_[item];
}

std::string Literals::number(double value) {
  return varies() ? next() : number_text(value);
}

std::string Literals::flag(bool value) {
  if (varies()) return next() + " != 0.0";
  return value ? "true" : "false";
}

std::string Literals::enumerator(int value, const std::string& type) {
  return fmt::format("static_cast<{}>({})", type,
                     varies() ? fmt::format("static_cast<int>({})", next()) : std::to_string(value));
}

std::string Literals::whole(std::int64_t value) {
  return varies() ? fmt::format("static_cast<std::int64_t>({})", next()) : std::to_string(value);
}

std::string Literals::natural(std::uint64_t value) {
  if (!varies()) return std::to_string(value) + "u";
  const std::string high = next(), low = next();
  return fmt::format("(static_cast<std::uint64_t>({}) << 32 | static_cast<std::uint64_t>({}))", high, low);
}

std::string Literals::numbers(const double* values, Index size) {
  if (varies()) return fmt::format("numbers + static_cast<Index>({})", next());
  std::string name = name_;
  for (int number = 2; !names_.insert(name).second; ++number) name = fmt::format("{}_{}", name_, number);
  tables_ += fmt::format("constexpr double {}[] = {{", name);
  for (Index i = 0; i < size; ++i) {
    tables_ += i == 0 ? "" : i % 8 == 0 ? ",\n    " : ", ";
    tables_ += number_text(values[i]);
  }
  tables_ += "};\n";
  return "table::" + name;
}

std::string Literals::function(const std::string& expression) {
  if (!gathered_) return LiteralWriter::function(expression);
  if (expression.empty()) return "Code{}";
  const auto which = std::ranges::find(*gathered_, expression) - gathered_->begin();
  if (which == std::ssize(*gathered_)) gathered_->push_back(expression);
  return fmt::format("Code{{{}}}", which);
}

std::string Literals::end_functions(const std::string& name) {
  const auto [type, is_new] = types_.try_emplace(std::move(*gathered_), name);
  gathered_.reset();
  if (!is_new) return type->second;
  functions_ += fmt::format(
      "struct {} {{\n  int which = -1;  // of the formulas; -1: always 0\n"
      "  double operator()([[maybe_unused]] const double* v) const {{\n    switch (which) {{\n",
      name);
  for (std::size_t i = 0; i < type->first.size(); ++i)
    functions_ += fmt::format("      case {}:\n        return {};\n", i, type->first[i]);
  functions_ += "      default:\n        return 0.0;\n    }\n  }\n};\n";
  return name;
}

}  // namespace stepwire::codegen
