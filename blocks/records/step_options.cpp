#include "blocks/records/step_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/base/expression/expression.hpp"

namespace stepwire {

namespace {

/// Parses a number with or without a unit, or a formula of numbers in SI, as parameters are substituted.
std::optional<unit::Quantity> read_number(const std::string& text) {
  if (const auto quantity = unit::parse_quantity(text)) return quantity;
  try {
    const double value = expression::Expression(text, [](std::string_view) { return false; })({});
    return std::isfinite(value) ? std::optional<unit::Quantity>({value, std::nullopt}) : std::nullopt;
  } catch (const expression::ExpressionError&) {
    return std::nullopt;
  }
}

}  // namespace

std::string StepOptions::text(std::string_view key) const {
  const Value* value = step_.find(key);
  if (!value) refuse(fmt::format("'{}' is missing, as in {}", key, example_));
  if (!value->text()) refuse(key, fmt::format("must be one word or number, as in {}", example_));
  return *value->text();
}

double StepOptions::number(std::string_view key, const std::optional<unit::Dimension>& dimension) const {
  const std::string given = text(key);
  const auto quantity = read_number(given);
  if (!quantity) refuse(key, fmt::format("'{}' is no number; write it as in {}", given, example_));
  if (quantity->dimension && dimension && *quantity->dimension != *dimension)
    refuse(key, fmt::format("{} is in {}, but must be in {}", given, unit::si_name(*quantity->dimension),
                            unit::si_name(*dimension)));
  return quantity->value;
}

double StepOptions::positive(std::string_view key, const unit::Dimension& dimension) const {
  const double value = number(key, dimension);
  if (!(value > 0.0)) refuse(key, fmt::format("{} is not allowed; it must be above 0", text(key)));
  return value;
}

Index StepOptions::whole(std::string_view key, Index least, Index most) const {
  const double value = number(key, unit::Dimension{});
  if (value != std::round(value) || value < static_cast<double>(least) || value > static_cast<double>(most))
    refuse(key,
           fmt::format("{} is not allowed; it must be a whole number from {} to {}", text(key), least, most));
  return static_cast<Index>(value);
}

std::size_t StepOptions::word(std::string_view key, const std::vector<std::string>& words) const {
  const std::string given = text(key);
  const auto at = std::find(words.begin(), words.end(), given);
  if (at == words.end())
    refuse(key, fmt::format("'{}' is not allowed; it must be one of: {}", given, fmt::join(words, ", ")));
  return static_cast<std::size_t>(at - words.begin());
}

void StepOptions::require_even(const Record& record) const {
  const auto row = first_uneven(record.time);
  if (!row) return;
  // Evenly spaced rows are made by steps, so these are rows of the file; the ones before them may be cut off.
  const auto in_file = std::find(record.file_times.begin(), record.file_times.end(),
                                 record.time[static_cast<std::size_t>(*row)]);
  const std::size_t file_row =
      record.file_rows[static_cast<std::size_t>(in_file - record.file_times.begin())];
  refuse(
      fmt::format("it needs evenly spaced rows, but {} is {:.6g} s and does not fit the mean interval of "
                  "{:.6g} s; put {{resample: {:.6g} s}} before it",
                  place_in_file(record.file, *record.table, record.time_name, file_row),
                  record.time[static_cast<std::size_t>(*row)], record.interval(), record.interval()));
}

void StepOptions::require_rows(const Record& record, Index least, const std::string& reason) const {
  if (record.rows() < least)
    refuse(fmt::format("{} has {} rows left, but {} needs {} or more", record.file, record.rows(), reason,
                       least));
}

void StepOptions::refuse(std::string_view key, const std::string& message) const {
  refuse(fmt::format("{}: {}", key, message), *step_.find(key));
}

void StepOptions::refuse(const std::string& message) const {
  refuse(message, step_);
}

void StepOptions::refuse(const std::string& message, const Value& where) const {
  refuse_(message.starts_with(name_ + ":") ? message : fmt::format("{}: {}", name_, message), where);
  throw std::logic_error("refusing must throw");
}

}  // namespace stepwire
