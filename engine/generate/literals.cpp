#include "engine/generate/literals.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>

namespace stepwire {

std::string number_text(double value) {
  if (std::isnan(value)) return "std::numeric_limits<double>::quiet_NaN()";
  if (std::isinf(value)) return value > 0.0 ? "unlimited" : "-unlimited";
  std::string text = fmt::format(FMT_COMPILE("{}"), value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string Literals::parameter(double value) {
  singles_.push_back(value);
  return varies(singles_.size() - 1) ? fmt::format("parameters[{}]", singles_.size() - 1) : "";
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

std::string Literals::whole(std::int64_t value) {
  constexpr std::int64_t exact = std::int64_t{1} << 53;  // a double holds all whole numbers up to here
  if (value > exact || value < -exact) return std::to_string(value);
  const std::string place = parameter(static_cast<double>(value));
  return place.empty() ? std::to_string(value) : fmt::format("static_cast<std::int64_t>({})", place);
}

std::string Literals::numbers(const double* values, Index size) {
  lists_.push_back({singles_.size(), in_lists_.size(), static_cast<std::size_t>(size)});
  in_lists_.insert(in_lists_.end(), values, values + size);
  const std::string place = parameter(0.0);  // known when all single numbers are
  if (!place.empty()) return fmt::format("parameters + static_cast<Index>({})", place);
  std::string name = name_;
  for (int number = 2; !names_.insert(name).second; ++number) name = fmt::format("{}_{}", name_, number);
  tables_.push_back({name, lists_.size() - 1});
  return "table::" + name;
}

std::string Literals::tables() const {
  std::string text;
  for (const Table& table : tables_) {
    const ProgramNumbers::List& list = lists_[table.list];
    text += fmt::format("constexpr double {}[] = {{", table.name);
    for (std::size_t i = 0; i < list.size; ++i) {
      text += i == 0 ? "" : i % 8 == 0 ? ",\n    " : ", ";
      text += number_text(
          in_lists_[list.first + i]);  // records have many numbers: no format where none is needed
    }
    text += "};\n";
  }
  return text;
}

ProgramNumbers Literals::all() const {
  ProgramNumbers all{singles_, lists_};
  for (ProgramNumbers::List& list : all.lists) {
    list.first += singles_.size();
    all.numbers[list.place] = static_cast<double>(list.first);
  }
  all.numbers.insert(all.numbers.end(), in_lists_.begin(), in_lists_.end());
  return all;
}

}  // namespace stepwire
