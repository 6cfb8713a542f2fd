#include <fmt/format.h>

#include <utility>

#include "engine/analyse/estimation/fit_keys.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/series.hpp"

namespace stepwire::estimation {

using yaml::form;

namespace {

const char* const subject = "fit.curves";
const char* const over_form = "'over' names the variable and its range in bare numbers: {i: [0, 1]}";

/// Returns the names for a curve's expression: the parameters that all records share, and the variable.
query::SymbolTable names_in_curve(const query::SymbolTable& names,
                                  const std::vector<FitParameter>& parameters, const std::string& variable) {
  query::SymbolTable known{names.file,
                           {{variable, unit::Dimension{}, {}}},
                           names.parameters,
                           {},
                           "is neither the variable nor a fitted parameter that all records share"};
  for (const FitParameter& parameter : parameters)
    if (!parameter.each_record) known.columns.push_back({parameter.name, parameter.dimension, {}});
  return known;
}

/// Returns the start values of these parameters; 0 for the variable.
std::vector<double> starts_of(const std::vector<std::string>& columns,
                              const std::vector<FitParameter>& parameters) {
  std::vector<double> starts(columns.size(), 0.0);
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (const FitParameter& parameter : parameters)
      if (parameter.name == columns[i]) starts[i] = parameter.start;
  return starts;
}

class CurveReader {
 public:
  CurveReader(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults)
      : node_(node), names_(names), faults_(faults) {}

  std::optional<FitCurve> read(const std::vector<FitParameter>& parameters) {
    if (!query::NamesReading(subject, names_, faults_).check(node_, fit_curve_form())) return std::nullopt;
    const yaml::Node *over = node_.find("over"), *y = node_.find("y");
    if (!over || !y) return std::nullopt;
    if (!over->is_map() || over->entries.size() != 1) return refused(*over, over_form);
    const yaml::Entry& variable = over->entries.front();
    const auto range = read_range(variable.value);
    auto series = query::read_series(*y, names_in_curve(names_, parameters, variable.key), subject, faults_);
    if (!series || !range) return std::nullopt;
    std::vector<double> otherwise = starts_of(series->formula.columns, parameters);
    FitCurve curve{std::move(*series), std::move(otherwise), variable.key, range->first,
                   range->second,      variable.key,         {},           0};
    curve.place = {names_.file, node_.mark};
    read_data(curve);
    if (const yaml::Node* label = node_.find("x_label"))
      curve.label = query::read_text(*label, names_, "fit.curves.x_label", faults_);
    return curve;
  }

 private:
  std::nullopt_t refused(const yaml::Node& at, const std::string& message) {
    faults_.add({{names_.file, at.mark}, subject, message, {}});
    return std::nullopt;
  }

  std::optional<std::pair<double, double>> read_range(const yaml::Node& range) {
    if (!range.is_list() || range.items.size() != 2) return refused(range, over_form);
    const auto from = query::read_number(range.items[0], names_, subject, faults_);
    const auto to = query::read_number(range.items[1], names_, subject, faults_);
    if (!from || !to) return std::nullopt;
    if (from->value < to->value) return std::pair{from->value, to->value};
    return refused(range, "the first number of a range is below the second");
  }

  void read_data(FitCurve& curve) {
    const yaml::Node* data = node_.find("data");
    if (!data) return;
    curve.data = query::read_formula(*data, names_, "fit.curves.data", faults_);
    if (curve.data)
      curve.recording = query::common_recording({&*curve.data}, names_, *data, "fit.curves.data", faults_);
  }

  const yaml::Node& node_;
  const query::SymbolTable& names_;
  yaml::Faults& faults_;
};

}  // namespace

const yaml::Key& fit_curve_form() {
  yaml::Key over = form::names(form::pair(form::computed()), 1);
  over.most = 1;
  static const yaml::Key form = form::keys(
      "a curve", "{y: c1*i + c0, over: {i: [0, 1]}, data: current}",
      {yaml::needed(yaml::key("y", "expression of fitted parameters and of the variable", form::series())),
       yaml::needed(yaml::key("over", "the variable and its range in bare numbers: {i: [0, 1]}", over)),
       yaml::key("data", "where the records have the variable; this range is shaded", form::expression()),
       yaml::key("x_label", "text at the axis of the variable")});
  return form;
}

std::optional<FitCurve> read_fit_curve(const yaml::Node& node, const query::SymbolTable& names,
                                       const std::vector<FitParameter>& parameters, yaml::Faults& faults) {
  return CurveReader(node, names, faults).read(parameters);
}

}  // namespace stepwire::estimation
