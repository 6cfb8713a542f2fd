// Swept values that a file defines.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/sampling/correlation.hpp"
#include "engine/base/text/count.hpp"
#include "engine/base/yaml/message.hpp"
#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/head_distribution.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/own_value.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

namespace {

// Cases of a sweep; the other swept values are run in each of them.

/// Returns a swept value as the text of a setting.
std::string setting_text(const yaml::Node& node) {
  return node.is_scalar() && !node.quoted ? node.text : yaml::yaml_line(node);
}

/// Returns the file's own value for an axis as the text of a setting. Without one it adds a fault of
/// `subject` and returns an empty text.
std::string base_value(const Sweep::Axis& axis, const std::string& subject, Report& report) {
  const auto refuse = [&](const yaml::Message& message) {
    report.add(axis.origin, subject, message);
    return std::string();
  };
  const Diagram& diagram = report.diagram();
  const auto name = find_name(diagram, axis.parameter);
  if (!name)
    return refuse("is no parameter of the file, of its parts or blocks" +
                  nearest_name(diagram, axis.parameter));
  const auto value = own_value(diagram, *name);
  if (!value)
    return refuse("has no value in the file, which each point but those that differ in it has; write one");
  return *value;
}

class CasesReading {
 public:
  CasesReading(const yaml::Node& cases, const Scope& scope, Sweep& sweep, Report& report)
      : cases_(cases), scope_(scope), sweep_(sweep), report_(report) {}

  void read() {
    const std::size_t before = report_.faults().size();
    if (sweep_.together)
      refuse(cases_.mark, "are run at each point of a grid; leave out 'together', or pair all by lists");
    if (!cases_.is_map() || cases_.entries.size() < 2)
      return refuse(cases_.mark,
                    "are two or more by name, and what each sets: {off: {}, on: {current: 1 A}}");
    for (const yaml::Entry& one : cases_.entries) check(one);
    if (report_.faults().size() != before) return;
    for (const yaml::Entry& one : cases_.entries)
      for (const yaml::Entry& set : one.value.entries) add_axis(set);
    add_label();
  }

 private:
  void refuse(const yaml::Mark& mark, const std::string& message) {
    report_.add(scope_.at(mark), "sweep.cases", message);
  }

  void check(const yaml::Entry& one) {
    if (!one.value.is_map() && one.value.kind != yaml::Node::Kind::empty)
      refuse(one.value.mark,
             fmt::format("'{}' is a map of what it sets: {{current: 1 A}}, or {{}}", one.key));
    for (const yaml::Entry& set : one.value.entries)
      if (find(set.key) != sweep_.axes.end())
        refuse(set.mark, fmt::format("'{}' is swept beside the cases; set it there or here", set.key));
  }

  std::vector<Sweep::Axis>::iterator find(const std::string& parameter) {
    return std::ranges::find(sweep_.axes, parameter, &Sweep::Axis::parameter);
  }

  /// Adds an axis with the values of one parameter in all cases, at the first case that sets it.
  void add_axis(const yaml::Entry& first) {
    if (find(first.key) != sweep_.axes.end()) return;
    Sweep::Axis axis{first.key, {}, scope_.at(first.mark), false, Sweep::Group::cases};
    std::vector<std::string> texts;
    std::vector<yaml::Mark> marks;
    std::vector<const yaml::Node*> values;
    for (const yaml::Entry& one : cases_.entries) {
      const yaml::Node* value = one.value.find(first.key);
      if (value) values.push_back(value);
      texts.push_back(value ? setting_text(*value) : base_value(axis, "sweep.cases." + first.key, report_));
      marks.push_back(value ? value->mark : one.mark);
    }
    have_units_together(values, "sweep.cases." + first.key, scope_, report_);
    axis.values = SweptValues(std::move(texts), std::move(marks));
    sweep_.axes.push_back(std::move(axis));
  }

  void add_label() {
    if (find(case_label) != sweep_.axes.end())
      return refuse(cases_.mark, "have a column 'case'; give what is swept another name");
    std::vector<std::string> names;
    std::vector<yaml::Mark> marks;
    for (const yaml::Entry& one : cases_.entries) {
      names.push_back(one.key);
      marks.push_back(one.mark);
    }
    sweep_.axes.push_back({case_label, SweptValues(std::move(names), std::move(marks)),
                           scope_.at(cases_.mark), true, Sweep::Group::cases});
  }

  const yaml::Node& cases_;
  const Scope& scope_;
  Sweep& sweep_;
  Report& report_;
};

/// Reads the key `cases` of a sweep, {NO: {}, H: {haptic: 1}}: an axis for each parameter that a case sets,
/// and a label with the names of the cases.
void read_cases(const yaml::Node& cases, const Scope& scope, Sweep& sweep, Report& report) {
  CasesReading(cases, scope, sweep, report).read();
}

// Sampled points of a sweep.

/// A sampled parameter of a sweep.
struct DrawnAxis {
  std::size_t axis = 0;  ///< index in Sweep::axes; its values are not yet set
  SpreadParameter spread;
};

/// Reads the correlations of sampled numbers: a matrix over all sampled axes in their order, or pairs.
class CorrelationReading {
 public:
  CorrelationReading(const yaml::Node& node, const std::vector<DrawnAxis>& drawn, const Sweep& sweep,
                     const HeadReading& read)
      : node_(node), drawn_(drawn), sweep_(sweep), read_(below(read, "correlation")) {
    const auto count = static_cast<Eigen::Index>(drawn.size());
    matrix_ = Eigen::MatrixXd::Identity(count, count);
  }

  /// Returns the factor that correlates the sampled axes; std::nullopt after a fault.
  std::optional<Eigen::MatrixXd> factor() {
    const std::size_t before = read_.report.faults().size();
    if (node_.is_map())
      read_pairs();
    else
      read_matrix();
    if (read_.report.faults().size() != before) return std::nullopt;
    auto factor = sampling::correlation_factor(matrix_);
    if (!factor)
      read_.fault(node_.mark,
                  "is not positive definite: no numbers can go together like that; bring its "
                  "numbers nearer to 0");
    return factor;
  }

 private:
  const std::string& name(std::size_t drawn) const { return sweep_.axes[drawn_[drawn].axis].parameter; }

  /// Returns the sampled axis of numbers with this name; adds a fault for an axis of words.
  std::optional<Eigen::Index> find(const yaml::Entry& entry) const {
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      if (name(i) != entry.key) continue;
      if (!drawn_[i].spread.is_words()) return static_cast<Eigen::Index>(i);
      read_.fault(entry.mark,
                  fmt::format("'{}' has words, which have no correlation; name numbers", entry.key));
      return std::nullopt;
    }
    std::vector<std::string> names;
    for (std::size_t i = 0; i < drawn_.size(); ++i) names.push_back(name(i));
    const bool listed = std::ranges::any_of(
        sweep_.axes, [&](const Sweep::Axis& axis) { return axis.parameter == entry.key; });
    read_.fault(entry.mark, fmt::format("'{}' is not drawn", entry.key) +
                                (listed ? yaml::Message("; it has the values of its list")
                                        : yaml::nearest_or_all(entry.key, names, "drawn are")));
    return std::nullopt;
  }

  std::optional<double> number(const yaml::Node& node) const {
    yaml::Key form = yaml::form::number();
    form.least = -1.0;
    form.most = 1.0;
    return read_.number(node, form);
  }

  void read_pairs() {
    for (const yaml::Entry& one : node_.entries) {
      const auto row = find(one);
      if (!one.value.is_map()) {
        read_.fault(one.value.mark, "is a map of the other parameters: {k: {m: 0.5}}");
        continue;
      }
      for (const yaml::Entry& other : one.value.entries) {
        const auto column = find(other);
        const auto value = number(other.value);
        if (row && column && value) set(*row, *column, *value, other.mark);
      }
    }
  }

  void set(Eigen::Index row, Eigen::Index column, double value, const yaml::Mark& mark) {
    if (row == column) return read_.fault(mark, "a parameter goes with itself by 1; name another one");
    if (matrix_(row, column) != 0.0 && matrix_(row, column) != value)
      return read_.fault(mark, fmt::format("this pair has the correlation {} already", matrix_(row, column)));
    matrix_(row, column) = matrix_(column, row) = value;
  }

  void read_matrix() {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < drawn_.size(); ++i)
      if (!drawn_[i].spread.is_words()) numbers.push_back(i);
    const auto has_size = [&](const yaml::Node& node) {
      return node.is_list() && node.items.size() == numbers.size();
    };
    if (!has_size(node_) || !std::ranges::all_of(node_.items, has_size))
      return read_.fault(
          node_.mark,
          fmt::format("is a matrix of {0} rows and {0} columns, for the numbers that are drawn in "
                      "their order, or has pairs: {{k: {{m: 0.5}}}}",
                      numbers.size()));
    bool all_numbers = true;
    for (std::size_t row = 0; row < numbers.size(); ++row)
      for (std::size_t column = 0; column < numbers.size(); ++column) {
        const auto value = number(node_.items[row].items[column]);
        all_numbers = all_numbers && value;
        matrix_(static_cast<Eigen::Index>(numbers[row]), static_cast<Eigen::Index>(numbers[column])) =
            value.value_or(0.0);
      }
    if (!all_numbers) return;
    if (matrix_ != matrix_.transpose()) return read_.fault(node_.mark, "is not symmetric");
    if ((matrix_.diagonal().array() != 1.0).any())
      read_.fault(node_.mark, "has 1 on its diagonal, since each parameter goes with itself by 1");
  }

  const yaml::Node& node_;
  const std::vector<DrawnAxis>& drawn_;
  const Sweep& sweep_;
  const HeadReading read_;
  Eigen::MatrixXd matrix_;
};

bool is_for_sensitivity(const sampling::Design& design) {
  return design.layout == sampling::Layout::saltelli || design.layout == sampling::Layout::morris;
}

/// Checks the requirements of a design on the sampled axes.
void check_design(const sampling::Design& design, std::size_t dimensions, const yaml::Node& section,
                  const HeadReading& read) {
  const bool is_sobol =
      design.layout == sampling::Layout::sobol || design.layout == sampling::Layout::saltelli;
  const std::size_t needed = design.layout == sampling::Layout::saltelli ? 2 * dimensions : dimensions;
  const std::size_t most = sampling::max_sobol_dimensions();
  if (is_sobol && needed > most)
    read.fault(section.mark, fmt::format("there are Sobol numbers for {} parameters, and {} are drawn; take "
                                         "kind: latin_hypercube",
                                         needed == dimensions ? most : most / 2, dimensions));
  const std::size_t each = design.points_of_sample(dimensions);
  if (design.samples > max_runs / each)
    read.fault(section.mark,
               fmt::format("makes {} runs for each sample; at most {} are made", each, max_runs));
}

std::optional<sampling::Design> read_design(const yaml::Node& section, const yaml::Node& node,
                                            std::size_t dimensions, const HeadReading& read) {
  const HeadReading of_design = below(read, "design");
  const std::size_t before = read.report.faults().size();
  sampling::Design design;
  design_table().read(node, design, of_design);
  check_design(design, dimensions, node, of_design);
  const yaml::Node* correlation = section.find("correlation");
  if (correlation && is_for_sensitivity(design))
    below(read, "correlation")
        .fault(correlation->mark,
               "a sensitivity is that of parameters which vary by themselves; leave it out, "
               "or take another kind of design");
  return read.report.faults().size() == before ? std::optional(design) : std::nullopt;
}

/// Reads the keys `design` and `correlation` of a sweep, and samples the values of its axes.
void draw_axes(const yaml::Node& section, const std::vector<DrawnAxis>& drawn, const Scope& scope,
               Sweep& sweep, Report& report) {
  const HeadReading read("sweep", scope, report);
  const yaml::Node *of_design = section.find("design"), *of_correlation = section.find("correlation");
  if (drawn.empty()) {
    for (const yaml::Node* node : {of_design, of_correlation})
      if (node)
        read.fault(node->mark,
                   "there is nothing to draw; a parameter is drawn by {uniform: [1 N, 3 N]}, "
                   "normal, lognormal, triangular or words");
    return;
  }
  if (!of_design)
    return read.fault(section.mark, fmt::format("'{}' is drawn; say how often: design: {{samples: 1000}}",
                                                sweep.axes[drawn.front().axis].parameter));
  const auto design = read_design(section, *of_design, drawn.size(), read);
  std::optional<Eigen::MatrixXd> factor;
  if (of_correlation) factor = CorrelationReading(*of_correlation, drawn, sweep, read).factor();
  if (!design || (of_correlation && !factor)) return;
  sweep.design = design;
  sampling::Points shares = sampling::points_of(*design, drawn.size());
  if (factor) sampling::correlate(shares, *factor);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    sweep.axes[drawn[i].axis].values = drawn[i].spread.values(shares[i]);
    std::vector<double>().swap(shares[i]);
  }
}

SweptValues listed(const yaml::Node& list) {
  std::vector<std::string> texts;
  std::vector<yaml::Mark> marks;
  for (const yaml::Node& item : list.items) {
    texts.push_back(setting_text(item));
    marks.push_back(item.mark);
  }
  return SweptValues(std::move(texts), std::move(marks));
}

/// Returns the list of values of a parameter; nullptr for a range. A list has no further keys.
const yaml::Node* list_of(const yaml::Entry& entry, const Scope& scope, Report& report) {
  if (!entry.value.is_map()) return &entry.value;
  const yaml::Node* list = entry.value.find("values");
  for (const yaml::Entry& other : entry.value.entries)
    if (list && other.key != "values")
      report.add(
          scope.at(other.mark), "sweep." + entry.key,
          fmt::format("has no '{}' beside 'values'; each value has its unit: [1 mm, 2 mm]", other.key));
  return list;
}

void read_axis(const yaml::Entry& entry, Sweep& sweep, const Scope& scope, Report& report) {
  const yaml::Node* list = list_of(entry, scope, report);
  Sweep::Axis axis{entry.key, {}, scope.at(entry.mark)};
  if (list && list->is_list()) {
    axis.values = listed(*list);
    std::vector<const yaml::Node*> items;
    for (const yaml::Node& item : list->items) items.push_back(&item);
    have_units_together(items, "sweep." + entry.key, scope, report);
    if (axis.values.empty()) report.add(scope.at(list->mark), "sweep." + entry.key, "has no values");
  } else {
    axis.values = read_range(entry.value, entry.key, scope, report);
  }
  sweep.axes.push_back(std::move(axis));
}

/// Returns a label axis: a column of words about the points of a sweep.
Sweep::Axis label(const char* name, SweptValues words, const Origin& origin) {
  return {name, std::move(words), origin, true};
}

/// Returns values that are the base at all points except a range of one point for each value, after the first
/// `before` points.
SweptValues apart(const Sweep::Axis& axis, const std::string& base, std::size_t before, std::size_t points) {
  std::vector<std::string> texts{base};
  std::vector<yaml::Mark> marks{axis.origin.mark};
  std::vector<std::uint32_t> which(points, 0);
  for (std::size_t i = 0; i < axis.count(); ++i) {
    texts.push_back(axis.text(i));
    marks.push_back(axis.mark(i));
    which[before + i] = static_cast<std::uint32_t>(i + 1);
  }
  return SweptValues(std::move(texts), std::move(marks), std::move(which));
}

/// Arranges the axes one at a time: the first point has all own values of the file, each other one differs in
/// one value.
void set_apart(Sweep& sweep, const Origin& origin, Report& report) {
  std::vector<std::string> names{nothing_differs}, to{""};
  std::vector<std::uint32_t> which{0};
  for (const Sweep::Axis& axis : sweep.axes) {
    for (std::size_t i = 0; i < axis.count(); ++i) to.push_back(axis.text(i));
    which.insert(which.end(), axis.count(), static_cast<std::uint32_t>(names.size()));
    names.push_back(axis.parameter);
  }
  std::size_t before = 1;
  for (Sweep::Axis& axis : sweep.axes) {
    const std::size_t count = axis.count();
    axis.values =
        apart(axis, base_value(axis, "sweep.one_at_a_time." + axis.parameter, report), before, to.size());
    before += count;
  }
  sweep.together = true;
  const std::vector<yaml::Mark> marks(to.size(), origin.mark);
  sweep.axes.push_back(
      label(differs_label, SweptValues(std::move(names), {marks.front()}, std::move(which)), origin));
  sweep.axes.push_back(label(differs_to_label, SweptValues(std::move(to), marks), origin));
}

/// Reads `keep`: a word, or named reductions.
void read_keep(const yaml::Node& section, Sweep& sweep, const Scope& scope, Report& report) {
  const yaml::Node* keep = section.find("keep");
  if (!keep) return;
  const HeadReading read("sweep.keep", scope, report);
  if (!keep->is_map()) return read.take(*keep, keep_word_form(), sweep.keep);
  sweep.keep = Sweep::Keep::numbers;
  sweep.kept = *keep;
  if (keep->entries.empty()) read.fault(keep->mark, "names no number of a run: {peak: max(x)}");
}

/// Reads the runs whose rows are kept beside the reduced numbers.
void read_recorded_runs(const yaml::Node& section, Sweep& sweep, const Scope& scope, Report& report) {
  const yaml::Node* record = section.find("record");
  if (!record) return;
  const HeadReading read("sweep.record", scope, report);
  recorded_runs_table().read(*record, sweep, read);
  if (sweep.keep == Sweep::Keep::rows)
    read.fault(
        record->mark,
        "all runs are recorded already; leave it out, or keep numbers of the runs: keep: {peak: max(x)}");
  if (sweep.keep == Sweep::Keep::final)
    read.fault(record->mark,
               "goes with numbers of the runs, not with their last rows: keep: {last: final(x)}");
}

void read_one_at_a_time(const yaml::Node& section, const yaml::Node& axes, const Scope& scope,
                        Report& report) {
  const auto refuse = [&](const yaml::Mark& mark, const char* message) {
    report.add(scope.at(mark), "sweep.one_at_a_time", message);
  };
  const auto has = [&](const char* key) { return section.find(key) ? std::size_t{1} : 0; };
  if (section.entries.size() > 1 + has("keep") + has("record"))
    return refuse(axes.mark, "stands alone in its sweep; all that is varied is named in it");
  if (!axes.is_map() || axes.entries.empty())
    return refuse(axes.mark, "is a map of parameters and their values: {mass: [1 kg, 3 kg]}");
  Sweep sweep;
  const std::size_t before = report.faults().size();
  for (const yaml::Entry& entry : axes.entries) {
    if (entry.key == nothing_differs)
      refuse(entry.mark, "'base' is the word for the point at which no parameter differs; rename it");
    read_axis(entry, sweep, scope, report);
  }
  read_keep(section, sweep, scope, report);
  read_recorded_runs(section, sweep, scope, report);
  if (report.faults().size() == before) set_apart(sweep, scope.at(axes.mark), report);
  if (sweep.count() > max_runs)
    return refuse(axes.mark,
                  fmt::format("makes {} runs; at most {} are made", sweep.count(), max_runs).c_str());
  report.diagram().sweep = std::move(sweep);
}

bool is_axis(const yaml::Entry& entry) {
  return !sweep_form().find(entry.key);
}

/// True for a map that is neither a list of values nor a range.
bool is_drawn(const yaml::Node& node) {
  const auto has = [&](const yaml::Key& key) { return node.find(key.name) != nullptr; };
  return node.is_map() && !node.find("values") && std::ranges::none_of(range_form().of, has);
}

/// Reads and samples the values of all axes. Adds a fault and returns false for too many runs.
bool read_axes(const yaml::Node& section, Sweep& sweep, const Scope& scope, Report& report) {
  const std::size_t before = report.faults().size();
  const auto refuse = [&] {
    report.add(scope.at(section.mark), "sweep",
               fmt::format("makes {} runs or more; at most {} are made", sweep.count(), max_runs));
    return false;
  };
  std::vector<DrawnAxis> drawn;
  for (const yaml::Entry& entry : section.entries) {
    if (!is_axis(entry)) continue;
    if (is_drawn(entry.value)) {
      if (auto spread = read_distribution(entry.value, entry.key, scope, report))
        drawn.push_back({sweep.axes.size(), std::move(*spread)});
      sweep.axes.push_back({entry.key, {}, scope.at(entry.mark), false, Sweep::Group::samples});
    } else {
      read_axis(entry, sweep, scope, report);
    }
  }
  if (report.faults().size() == before) draw_axes(section, drawn, scope, sweep, report);
  if (const yaml::Node* cases = section.find("cases"); cases && report.faults().size() == before)
    read_cases(*cases, scope, sweep, report);
  return sweep.count() <= static_cast<double>(max_runs) || refuse();
}

}  // namespace

void read_sweep(const Scope& scope, Report& report) {
  const yaml::Node* node = scope.document->root.find("sweep");
  if (!node) return;
  if (!node->is_map())
    return report.add(scope.at(node->mark), "sweep",
                      "must be a map of parameter: {from, to, count} or {values: [..]}");
  if (const yaml::Node* one = node->find("one_at_a_time"))
    return read_one_at_a_time(*node, *one, scope, report);
  Sweep sweep;
  if (const yaml::Node* together = node->find("together"))
    HeadReading("sweep.together", scope, report).take(*together, yaml::form::truth(), sweep.together);
  read_keep(*node, sweep, scope, report);
  read_recorded_runs(*node, sweep, scope, report);
  if (!read_axes(*node, sweep, scope, report)) return;
  if (const yaml::Node* keep = node->find("keep"); keep && sweep.axes.empty())
    report.add(scope.at(keep->mark), "sweep.keep",
               "there are no runs to keep something of; name what varies");
  for (const Sweep::Axis& axis : sweep.axes)
    if (sweep.together && axis.count() != sweep.axes.front().count())
      report.add(axis.origin, "sweep." + axis.parameter,
                 fmt::format("has {}, '{}' has {}; with 'together: true' they are paired",
                             text::counted(axis.count(), "value"), sweep.axes.front().parameter,
                             sweep.axes.front().count()));
  report.diagram().sweep = std::move(sweep);
}

}  // namespace stepwire::diagram
