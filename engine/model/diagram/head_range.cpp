// Evenly spaced values of a sweep.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/head_distribution.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/head_range.hpp"

namespace stepwire::diagram {

namespace {

/// Returns value i of a range of n + 1. It multiplies first, so that whole ends give whole values in between;
/// the last value is exactly `to`.
double value_of_range(double from, double to, double i, double n) {
  if (i == n) return to;
  const double rise = i * (to - from);
  return std::isfinite(rise) ? from + rise / n : from * (1.0 - i / n) + to * (i / n);
}

/// Reader of {from: .., to: .., count: ..}; returns no values after a fault.
class RangeReading {
 public:
  RangeReading(const yaml::Node& map, const std::string& name, const Scope& scope, Report& report)
      : map_(map), subject_("sweep." + name), scope_(scope), report_(report) {}

  SweptValues values() {
    if (!has_form()) return {};
    const auto from = number("from");
    const auto to = from ? number("to") : std::nullopt;
    const auto count = to ? number("count") : std::nullopt;
    if (!count) return {};
    if (const std::string complaint = unit_complaint(to->dimension, from->dimension); !complaint.empty())
      return refuse(map_.find("to")->mark, fmt::format("'to' {}", complaint));
    if (count->value < 2 || count->value != std::floor(count->value) || count->value > max_runs)
      return refuse(map_.find("count")->mark,
                    fmt::format("'count' must be a whole number from 2 to {}", max_runs));
    const auto written_from = written_number(*map_.find("from")),
               written_to = written_number(*map_.find("to"));
    // Computes in the written unit: 1 mm to 9 mm is whole in millimetres, not in metres.
    if (written_from && written_to && written_from->unit == written_to->unit)
      return numbers(written_from->number, written_to->number, count->value, written_from->unit);
    const auto& dimension = from->dimension ? from->dimension : to->dimension;
    return numbers(from->value, to->value, count->value,
                   dimension && *dimension != unit::Dimension{} ? unit::si_name(*dimension) : "");
  }

 private:
  struct Number {
    double value;
    std::optional<unit::Dimension> dimension;
  };

  SweptValues refuse(const yaml::Mark& mark, yaml::Message message) {
    report_.add(scope_.at(mark), subject_, std::move(message));
    return {};
  }

  bool has_form() {
    const std::size_t before = report_.faults().size();
    if (map_.is_map())
      HeadReading(subject_, scope_, report_).check(map_, range_form());
    else
      refuse(map_.mark, "is written [.., ..], {from: .., to: .., count: ..} or {uniform: [.., ..]}");
    return report_.faults().size() == before;
  }

  std::optional<Number> number(const char* key) {
    const yaml::Node& node = *map_.find(key);
    const auto written = ValueReader(scope_.parameters, report_, scope_.index).read(node, subject_);
    if (!written) return std::nullopt;
    if (const double* number = std::get_if<double>(&written->value.content))
      return Number{*number, written->dimension};
    refuse(node.mark, yaml::fault_text("'{}' is no number; words are swept as a list", written->text));
    return std::nullopt;
  }

  SweptValues numbers(double from, double to, double count, const std::string& unit) const {
    std::vector<double> numbers;
    for (double i = 0; i < count; ++i) numbers.push_back(value_of_range(from, to, i, count - 1));
    return {std::move(numbers), unit, map_.mark};
  }

  const yaml::Node& map_;
  const std::string subject_;
  const Scope& scope_;
  Report& report_;
};

}  // namespace

SweptValues read_range(const yaml::Node& map, const std::string& name, const Scope& scope, Report& report) {
  return RangeReading(map, name, scope, report).values();
}

}  // namespace stepwire::diagram
