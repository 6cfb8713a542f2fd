#include "engine/view/plot/empty_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/analyse/query/number.hpp"
#include "engine/base/text/count.hpp"
#include "engine/view/plot/linear_rows.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {

namespace {

constexpr std::size_t most_listed = 6;

bool selects(const query::Formula& where, const record::Recording& recording) {
  return std::ranges::any_of(query::evaluate(where, recording),
                             [](double value) { return value != 0.0 && !std::isnan(value); });
}

/// Returns "k is 1, 2 or 4", or "x is from -1 to 3" for many values; empty for a column of words or without
/// numbers.
std::string values_of(const table::Column& column) {
  std::set<double> values;
  for (const double value : column.values)
    if (!std::isnan(value)) values.insert(value);
  if (values.empty()) return "";
  const std::string unit = column.unit.empty() || column.unit == "1" ? "" : " " + column.unit;
  if (values.size() > most_listed)
    return fmt::format("{} is from {} to {}{}", column.name, query::short_number(*values.begin()),
                       query::short_number(*values.rbegin()), unit);
  std::string list;
  for (auto value = values.begin(); value != values.end(); ++value)
    list += (value == values.begin()            ? ""
             : std::next(value) == values.end() ? " or "
                                                : ", ") +
            query::short_number(*value);
  return fmt::format("{} is {}{}", column.name, list, unit);
}

std::string sentence(const std::string& subject, const query::Formula& where,
                     const record::Recording& recording) {
  std::vector<std::string> values;
  for (const std::string& name : std::set<std::string>(where.columns.begin(), where.columns.end()))
    if (const table::Column* column = recording.table.find(name))
      if (const std::string text = values_of(*column); !text.empty()) values.push_back(text);
  const std::size_t rows = recording.table.rows(), runs = recording.starts.size();
  return fmt::format("{}: '{}' selects none of {}{}{}", subject, where.text, text::counted(rows, "row"),
                     runs > 1 ? fmt::format(" ({} runs)", runs) : "",
                     values.empty() ? "" : fmt::format(", in which {}", fmt::join(values, " and ")));
}

/// Collects the sentences of one panel.
class PanelSelections {
 public:
  PanelSelections(const Panel& panel, std::string subject, std::span<const record::Recording> recordings)
      : panel_(panel), subject_(std::move(subject)), recordings_(recordings) {}

  std::vector<std::string> found() {
    if (panel_.where && !panel_.recordings.empty()) {
      const std::size_t recording = panel_.where->recording.value_or(panel_.recordings.front());
      if (panel_.find("of") && LinearRows(panel_, recordings_).runs() == 0)
        add(*panel_.where, recording);
      else
        check(panel_.where, recording);
    }
    for (const Motion& motion : panel_.motions) check(motion.where, motion.recording);
    for (const Rose& rose : panel_.roses) check(rose.where, rose.recording);
    return std::move(found_);
  }

 private:
  void check(const std::optional<query::Formula>& where, std::size_t recording) {
    if (where && recording < recordings_.size() && !selects(*where, recordings_[recording]))
      add(*where, recording);
  }

  void add(const query::Formula& where, std::size_t recording) {
    if (recording < recordings_.size()) found_.push_back(sentence(subject_, where, recordings_[recording]));
  }

  const Panel& panel_;
  std::string subject_;
  std::span<const record::Recording> recordings_;
  std::vector<std::string> found_;
};

/// Returns "figure 2, panel 3" with the title of the panel or figure; panels are numbered where there are
/// several.
std::string subject_of(const std::vector<Figure>& figures, std::size_t figure, std::size_t panel) {
  const Figure& all = figures[figure];
  std::string subject = figures.size() > 1 ? fmt::format("figure {}", figure + 1) : "figure";
  if (all.panels.size() > 1) subject += fmt::format(", panel {}", panel + 1);
  const std::string& title = all.panels[panel].title.empty() ? all.title : all.panels[panel].title;
  return title.empty() ? subject : fmt::format("{}, '{}'", subject, title);
}

}  // namespace

std::vector<std::string> empty_selections(const std::vector<Figure>& figures,
                                          std::span<const record::Recording> recordings) {
  std::vector<std::string> all;
  for (std::size_t f = 0; f < figures.size(); ++f)
    for (std::size_t p = 0; p < figures[f].panels.size(); ++p) {
      const auto found = PanelSelections(figures[f].panels[p], subject_of(figures, f, p), recordings).found();
      all.insert(all.end(), found.begin(), found.end());
    }
  return all;
}

}  // namespace stepwire::plot
