#include "engine/model/diagram/head_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/unit/meaning.hpp"
#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/head_keys.hpp"

namespace stepwire::diagram {

namespace {

// Distributions of swept numbers and words.

using Kind = sampling::Distribution::Kind;

/// Argument of a distribution: its name and kind. A difference such as a standard deviation is converted
/// without the offset of its unit: a deviation in kelvin is the same in degrees Celsius.
struct Argument {
  const char* name;
  enum class Of { place, way, ratio } of = Of::place;
};

struct Row {
  const char* key;
  Kind kind;
  std::vector<Argument> arguments;
};

const std::vector<Row>& rows() {
  using Of = Argument::Of;
  static const std::vector<Row> all{{"uniform", Kind::uniform, {{"low"}, {"high"}}},
                                    {"normal", Kind::normal, {{"mean"}, {"deviation", Of::way}}},
                                    {"lognormal", Kind::lognormal, {{"median"}, {"variation", Of::ratio}}},
                                    {"triangular", Kind::triangular, {{"low"}, {"mode"}, {"high"}}}};
  return all;
}

/// Reader of the list of numbers of one distribution.
class NumbersReading {
 public:
  NumbersReading(const yaml::Node& list, const Row& row, const std::string& name, const Scope& scope,
                 Report& report)
      : list_(list),
        row_(row),
        subject_(fmt::format("sweep.{}.{}", name, row.key)),
        scope_(scope),
        report_(report) {}

  std::optional<SpreadParameter> read() {
    if (!list_.is_list() || list_.items.size() != row_.arguments.size())
      return refuse(list_.mark, "is a list of " + names());
    if (!take_unit() || !alike_in_units()) return std::nullopt;
    for (std::size_t i = 0; i < row_.arguments.size(); ++i)
      if (!take(i)) return std::nullopt;
    result_.distribution.kind = row_.kind;
    return check() ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  std::nullopt_t refuse(const yaml::Mark& mark, yaml::Message message) {
    report_.add(scope_.at(mark), subject_, std::move(message));
    return std::nullopt;
  }

  std::string names() const {
    std::string text;
    for (const Argument& one : row_.arguments) text += (text.empty() ? "[" : ", ") + std::string(one.name);
    return text + "]";
  }

  std::optional<WrittenValue> value_of(const yaml::Node& node) {
    auto written = ValueReader(scope_.parameters, report_, scope_.index).read(node, subject_);
    if (!written || std::holds_alternative<double>(written->value.content)) return written;
    return refuse(node.mark, yaml::fault_text("'{}' is no number", written->text));
  }

  /// Reads the unit of the first number, as written or in SI.
  bool take_unit() {
    const yaml::Node& first = list_.items.front();
    const auto value = value_of(first);
    if (!value) return false;
    dimension_ = value->dimension;
    if (const auto written = written_number(first))
      result_.unit = written->unit;
    else if (dimension_ && *dimension_ != unit::Dimension{})
      result_.unit = unit::si_name(*dimension_);
    unit_ = unit::parse_unit(result_.unit).value_or(unit::Unit{});
    return true;
  }

  /// Refuses a number without unit beside numbers with units; a ratio has none.
  bool alike_in_units() {
    std::vector<const yaml::Node*> numbers;
    for (std::size_t i = 0; i < row_.arguments.size(); ++i)
      if (row_.arguments[i].of != Argument::Of::ratio) numbers.push_back(&list_.items[i]);
    return have_units_together(numbers, subject_, scope_, report_);
  }

  bool take(std::size_t i) {
    const yaml::Node& node = list_.items[i];
    const Argument& argument = row_.arguments[i];
    const auto value = value_of(node);
    if (!value) return false;
    const bool is_ratio = argument.of == Argument::Of::ratio;
    unit::Dimension demanded;
    if (!is_ratio && dimension_) demanded = *dimension_;
    if (argument.of == Argument::Of::way && unit::is_temperature(demanded)) demanded.zeros = 0.0;
    if (const std::string complaint = unit_complaint(value->dimension, demanded); !complaint.empty()) {
      refuse(node.mark, fmt::format("'{}' {}", argument.name, complaint));
      return false;
    }
    const double si = std::get<double>(value->value.content);
    result_.distribution.numbers[i] = is_ratio ? si : in_unit(node, si, value->dimension, argument);
    return true;
  }

  /// Returns a number in the unit of the first one; a bare number beside a unit is in SI.
  double in_unit(const yaml::Node& node, double si, const std::optional<unit::Dimension>& dimension,
                 const Argument& argument) const {
    const auto written = written_number(node);
    if (result_.unit.empty() || (written && dimension && written->unit == result_.unit))
      return written && dimension ? written->number : si;
    if (argument.of == Argument::Of::way) return static_cast<double>(si / unit_.scale);
    return unit_.from_si(si);
  }

  double number(std::size_t i) const { return result_.distribution.numbers[i]; }

  bool above_zero(std::size_t i) {
    if (number(i) > 0.0) return true;
    refuse(list_.items[i].mark,
           yaml::fault_text("'{}' is {}; it must be above 0", row_.arguments[i].name, list_.items[i].text));
    return false;
  }

  /// Refuses a relative variation of a temperature in degC, which is a share of its kelvins.
  bool has_true_zero() {
    if (unit_.offset == 0.0L) return true;
    refuse(list_.items[1].mark,
           yaml::fault_text(
               "{} of a temperature in {} is a share of its kelvins; write normal: [{}, 2 K] with a "
               "deviation in K",
               list_.items[1].text, result_.unit, list_.items[0].text));
    return false;
  }

  /// True where one number is below another one, or equal if allowed; otherwise adds a fault.
  bool in_order(std::size_t low, std::size_t high, bool may_be_equal) {
    if (number(low) < number(high) || (may_be_equal && number(low) == number(high))) return true;
    refuse(list_.items[high].mark,
           yaml::fault_text("'{}' {} is {} '{}' {}; it must be {}above it", row_.arguments[high].name,
                            list_.items[high].text, number(low) == number(high) ? "equal to" : "below",
                            row_.arguments[low].name, list_.items[low].text,
                            may_be_equal ? "equal to or " : ""));
    return false;
  }

  bool check() {
    switch (row_.kind) {
      case Kind::normal:
        return above_zero(1);
      case Kind::lognormal:
        return has_true_zero() && above_zero(0) && above_zero(1);
      case Kind::triangular:
        return in_order(0, 1, true) && in_order(1, 2, true) && in_order(0, 2, false);
      default:
        return in_order(0, 1, false);
    }
  }

  const yaml::Node& list_;
  const Row& row_;
  const std::string subject_;
  const Scope& scope_;
  Report& report_;
  SpreadParameter result_;
  std::optional<unit::Dimension> dimension_;
  unit::Unit unit_;
};

std::optional<SpreadParameter> read_words(const yaml::Node& map, const HeadReading& read) {
  SpreadParameter result;
  result.distribution.kind = Kind::words;
  if (!map.is_map() || map.entries.size() < 2) {
    read.fault(map.mark, "is a map of words and their weights: {ice: 1, road: 3}");
    return std::nullopt;
  }
  bool fine = true;
  for (const yaml::Entry& entry : map.entries) {
    double weight = 0.0;
    below(read, entry.key).take(entry.value, yaml::form::above_zero(yaml::form::number()), weight);
    fine = fine && weight > 0.0;
    result.distribution.weights.push_back(weight);
    result.words.push_back(entry.key);
  }
  return fine ? std::optional(std::move(result)) : std::nullopt;
}

// Evenly spaced values of a sweep.

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
    if (!have_units_together({map_.find("from"), map_.find("to")}, subject_, scope_, report_)) return {};
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

bool have_units_together(const std::vector<const yaml::Node*>& numbers, const std::string& subject,
                         const Scope& scope, Report& report) {
  const auto has_unit = [](const yaml::Node* node) {
    const auto written = written_number(*node);
    return written && !written->unit.empty() && written->unit != "%" && written->unit != "1";
  };
  bool together = true;
  std::vector<std::vector<const yaml::Node*>> elements;  // of lists, by place
  for (const yaml::Node* node : numbers)
    for (std::size_t k = 0; node->is_list() && k < node->items.size(); ++k) {
      elements.resize(std::max(elements.size(), k + 1));
      elements[k].push_back(&node->items[k]);
    }
  for (const auto& place : elements)
    together = have_units_together(place, subject, scope, report) && together;
  const auto with_unit = std::ranges::find_if(numbers, has_unit);
  for (const yaml::Node* node : numbers) {
    if (with_unit == numbers.end() || !is_bare(*node)) continue;
    together = false;
    report.add(scope.at(node->mark), subject,
               yaml::fault_text("{} has no unit beside {}; write {} {}", node->text, (*with_unit)->text,
                                node->text, written_number(**with_unit)->unit));
  }
  return together;
}

SweptValues SpreadParameter::values(const std::vector<double>& shares) const {
  if (!is_words()) {
    std::vector<double> numbers;
    numbers.reserve(shares.size());
    for (const double share : shares) numbers.push_back(distribution.quantile(share));
    return {std::move(numbers), unit, mark};
  }
  std::vector<std::uint32_t> which;
  which.reserve(shares.size());
  for (const double share : shares) which.push_back(static_cast<std::uint32_t>(distribution.quantile(share)));
  return SweptValues(words, std::vector<yaml::Mark>(words.size(), mark), std::move(which));
}

std::optional<SpreadParameter> read_distribution(const yaml::Node& map, const std::string& name,
                                                 const Scope& scope, Report& report) {
  const HeadReading read("sweep." + name, scope, report);
  const std::size_t before = report.faults().size();
  read.check(map, distribution_form());
  if (report.faults().size() != before) return std::nullopt;
  std::optional<SpreadParameter> result;
  if (const yaml::Node* words = map.find("words")) result = read_words(*words, below(read, "words"));
  for (const Row& row : rows())
    if (const yaml::Node* list = map.find(row.key))
      result = NumbersReading(*list, row, name, scope, report).read();
  if (result) result->mark = map.mark;
  return result;
}

SweptValues read_range(const yaml::Node& map, const std::string& name, const Scope& scope, Report& report) {
  return RangeReading(map, name, scope, report).values();
}

}  // namespace stepwire::diagram
