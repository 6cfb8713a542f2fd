// Sampled points of a sweep.
#include "engine/model/diagram/head_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/sampling/correlation.hpp"
#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/head_range.hpp"

namespace stepwire::diagram {

namespace {

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

}  // namespace

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

}  // namespace stepwire::diagram
