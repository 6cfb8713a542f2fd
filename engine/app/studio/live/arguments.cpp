#include "engine/app/studio/live/arguments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace stepwire::live {

namespace {

[[noreturn]] void refuse_argument(const char* key, const char* what) {
  throw std::runtime_error(fmt::format("the argument '{}' is missing or is no {}", key, what));
}

}  // namespace

std::optional<double> Arguments::number_if_any(const char* key) const {
  const json::Json* found = of_.find(key);
  if (!found || found->is_null()) return std::nullopt;
  const auto number = found->as_number();
  if (!number || !std::isfinite(*number)) refuse_argument(key, "finite number");
  return number;
}

std::optional<double> Arguments::number_if_no_text(const char* key) const {
  const json::Json* found = of_.find(key);
  return found && found->as_text() ? std::nullopt : std::optional(number(key));
}

double Arguments::number(const char* key) const {
  const auto number = number_if_any(key);
  if (!number) refuse_argument(key, "number");
  return *number;
}

std::string Arguments::text(const char* key) const {
  const json::Json* found = of_.find(key);
  if (!found || !found->as_text()) refuse_argument(key, "text");
  return *found->as_text();
}

bool Arguments::flag(const char* key) const {
  const json::Json* found = of_.find(key);
  const auto flag = found ? found->as_flag() : std::nullopt;
  if (!flag) refuse_argument(key, "true or false");
  return *flag;
}

const json::Json& Arguments::list(const char* key) const {
  const json::Json* found = of_.find(key);
  if (!found || !found->is_list()) refuse_argument(key, "list");
  return *found;
}

bool Arguments::flag_or(const char* key, bool otherwise) const {
  return of_.find(key) ? flag(key) : otherwise;
}

std::vector<double> Arguments::numbers(const char* key) const {
  std::vector<double> numbers;
  for (const json::Json& item : list(key).items()) {
    const auto number = item.as_number();
    if (!number || !std::isfinite(*number)) refuse_argument(key, "list of finite numbers");
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<std::size_t> Arguments::indices(const char* key) const {
  std::vector<std::size_t> indices;
  for (const double number : numbers(key)) {
    if (number < 0.0 || number > 1e9 || number != std::floor(number))
      refuse_argument(key, "list of whole numbers");
    indices.push_back(static_cast<std::size_t>(number));
  }
  return indices;
}

}  // namespace stepwire::live
