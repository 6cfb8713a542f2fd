#include "engine/model/diagram/coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

namespace {

constexpr std::string_view by = " by ";

/// Returns the quotient of the units of two consecutive coefficients.
unit::Dimension step_of(const ParameterSpec& spec) {
  const auto unit = unit::parse_unit(std::string_view(spec.unit).substr(spec.unit.find(by) + by.size()));
  return unit ? unit->dimension : unit::Dimension{};
}

bool are_scalars(const yaml::Node& list) {
  return list.is_list() &&
         std::ranges::all_of(list.items, [](const yaml::Node& item) { return item.is_scalar(); });
}

}  // namespace

bool are_coefficients(const ParameterSpec& spec) {
  return spec.unit.find(by) != std::string::npos;
}

std::optional<WrittenValue> read_coefficients(const ValueReader& reader, FaultReport& report,
                                              const ParameterSpec& spec, const yaml::Node& list,
                                              const std::string& subject) {
  if (!are_scalars(list) || list.items.empty()) return reader.read(list, subject);
  const unit::Dimension step = step_of(spec);
  WrittenValue result{{Eigen::VectorXd(static_cast<Eigen::Index>(list.items.size()))}, {}, "the list"};
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const auto written = reader.read(list.items[i], subject);
    const double* number = written ? std::get_if<double>(&written->value.content) : nullptr;
    if (!number) return written ? reader.read(list, subject) : std::nullopt;
    std::get<Eigen::VectorXd>(result.value.content)[static_cast<Eigen::Index>(i)] = *number;
    if (!written->dimension) continue;
    const auto power = static_cast<double>(list.items.size() - 1 - i);
    const unit::Dimension last = *written->dimension / unit::power(step, power);
    if (!result.dimension) result.dimension = last;
    if (*result.dimension == last) continue;
    report.add(reader.at(list.items[i].mark), subject,
               fmt::format("{} is in {}; beside the coefficients before it, it must be in {}", written->text,
                           unit::si_name(*written->dimension),
                           unit::si_name(*result.dimension * unit::power(step, power))));
    return std::nullopt;
  }
  return result;
}

}  // namespace stepwire::diagram
