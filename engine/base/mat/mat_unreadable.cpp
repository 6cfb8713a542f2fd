#include "engine/base/mat/mat_unreadable.hpp"

#include <fmt/format.h>

namespace stepwire::mat {
namespace {

/// Describes an object of a class of MATLAB or of a user.
std::string object_text(const std::string& class_name) {
  return class_name.empty() ? "an object" : fmt::format("an object of the class {}", class_name);
}

/// Returns MATLAB code that extracts the vectors t and x from an object.
std::string object_cure(const std::string& name, const std::string& class_name) {
  if (class_name == "timeseries") return fmt::format("t = {0}.Time; x = {0}.Data", name);
  if (class_name == "timetable")
    return fmt::format("t = seconds({0}.Properties.RowTimes - {0}.Properties.RowTimes(1)); x = {0}.Variables",
                       name);
  if (class_name == "table") return fmt::format("x = {}.Variables", name);
  if (class_name == "datetime") return fmt::format("t = seconds({0} - {0}(1))", name);
  if (class_name == "duration") return fmt::format("t = seconds({})", name);
  return fmt::format("t = {0}.Time; x = {0}.Data", name);
}

std::string cure(const std::string& name, MatUnreadable kind, const std::string& class_name) {
  switch (kind) {
    case MatUnreadable::complex:
      return fmt::format("re = real({0}); im = imag({0})", name);
    case MatUnreadable::sparse:
      return fmt::format("x = full({})", name);
    case MatUnreadable::cell:
      return fmt::format("x = {}{{1}}", name);
    case MatUnreadable::function:
      return fmt::format("t = linspace(0, 1, 1001)'; x = {}(t)", name);
    case MatUnreadable::struct_array:
      return fmt::format("x = {}(1).values", name);
    case MatUnreadable::object:
      return object_cure(name, class_name);
  }
  return "";
}

std::string what(MatUnreadable kind, const std::string& class_name) {
  switch (kind) {
    case MatUnreadable::complex:
      return "complex";
    case MatUnreadable::sparse:
      return "a sparse matrix";
    case MatUnreadable::cell:
      return "a cell array";
    case MatUnreadable::function:
      return "a function handle";
    case MatUnreadable::struct_array:
      return "an array of more than 1000 structs";
    case MatUnreadable::object:
      return object_text(class_name) + ", which MATLAB alone can read";
  }
  return "";
}

}  // namespace

std::string unreadable_text(const std::string& name, MatUnreadable kind, const std::string& class_name) {
  const std::string lines = cure(name, kind, class_name);
  const char* const saved = kind == MatUnreadable::complex ? "'t', 're', 'im'" : "'t', 'x'";
  return fmt::format("'{}' is {}; save numbers in MATLAB: `{}; save('f.mat', {}, '-v7')`", name,
                     what(kind, class_name), lines, saved);
}

}  // namespace stepwire::mat
