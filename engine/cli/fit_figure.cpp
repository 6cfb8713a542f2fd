// What a fit found, as pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/cli/fitting.hpp"
#include "engine/figure/matrix_chart.hpp"

namespace stepwire {

namespace {

/// Recordings and the text of a figure over them, as a diagram file would have it.
struct Asked {
  std::vector<Recording> recordings;
  Names names{"fit", {}, {}};
  std::string text;

  /// A recording of these columns, which are named apart from those of others by its number.
  std::string add(std::vector<Column> columns) {
    const std::size_t number = recordings.size();
    Recording recording;
    for (Column& column : columns) {
      column.name += fmt::format("_{}", number);
      const auto unit = column.unit.empty() ? std::nullopt : parse_unit(column.unit);
      names.columns.push_back({column.name, unit ? std::optional(unit->dimension) : std::nullopt, number});
      recording.table.columns.push_back(std::move(column));
    }
    recordings.push_back(std::move(recording));
    return fmt::format("_{}", number);
  }
};

std::string picture(const Asked& asked, const std::string& title) {
  Faults faults;
  auto figures = read_figures(parse_document(asked.text, "fit").root, asked.names, faults);
  faults.throw_if_any();
  figures.front().title = title;
  return draw(figures.front(), asked.recordings).svg;
}

/// A text as YAML takes it in single quotes.
std::string text_of(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

/// " in mm" for a unit that is known.
std::string drawn_in(const std::string& unit) {
  return unit.empty() ? "" : " in " + unit;
}

std::string si_of(const std::optional<Dimension>& dimension) {
  return dimension && *dimension != Dimension{} ? si_name(*dimension) : "";
}

/// Worst, middle and best of the records in a comparison, by number; what is constant counts as the best.
std::vector<std::size_t> telling(const FitResult& result, std::size_t comparison) {
  const auto agreement = [&](std::size_t record) {
    const double found = result.records[record].comparisons[comparison].agreement;
    return std::isfinite(found) ? found : 100.0;
  };
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < result.records.size(); ++i)
    if (comparison < result.records[i].comparisons.size()) all.push_back(i);
  std::stable_sort(all.begin(), all.end(),
                   [&](std::size_t a, std::size_t b) { return agreement(a) < agreement(b); });
  if (all.size() <= 3) return all;
  return {all.front(), all[all.size() / 2], all.back()};
}

/// Record and model over time, the residual, and both over whatever the file names, for one record.
void add_panels(const FitComparison& comparison, const FittedRecord& record, const ComparedRows& rows,
                const std::string& word, Asked& asked) {
  const std::string si = si_of(comparison.model.formula.dimension), unit = comparison.model.unit_text;
  std::vector<Column> columns{
      {"time", "s", rows.time}, {"measured", si, rows.measured}, {"model", si, rows.model}};
  for (std::size_t i = 0; i < rows.against.size(); ++i)
    columns.push_back(
        {fmt::format("against{}", i), si_of(comparison.against[i].formula.dimension), rows.against[i]});
  const std::string number = asked.add(std::move(columns));
  const std::string both =
      fmt::format("y: [measured{0}{1}, model{0}{1}], legend: [{2}, model], y_label: {3}", number,
                  drawn_in(unit), text_of(word), text_of(comparison.model.label));
  // A stretch in which single periods are seen.
  const double begin = rows.time.front(),
               end = std::min(rows.time.back(), begin + 0.3 * (rows.time.back() - begin));
  asked.text += fmt::format(
      "  - {{plot: lines, x: time{} in s, {}, x_label: time, x_range: [{:.9g} s, {:.9g} s], title: {}}}\n",
      number, both, begin, end,
      text_of(fmt::format("{}{}{}{}", record.label, record.label.empty() ? "" : ": ", agreement_text(rows),
                          record.held_out ? ", held out" : "")));
  asked.text += fmt::format(
      "  - {{plot: lines, x: time{0} in s, y: model{0} - measured{0}{1}, x_label: time, y_label: "
      "residual}}\n",
      number, drawn_in(unit));
  for (std::size_t i = 0; i < rows.against.size(); ++i)
    asked.text +=
        fmt::format("  - {{plot: loop, x: against{}{}{}, {}, x_label: {}}}\n", i, number,
                    drawn_in(comparison.against[i].unit_text), both, text_of(comparison.against[i].label));
}

std::string records_picture(const FitRequest& request, const FitResult& result, std::size_t which) {
  const FitComparison& comparison = request.comparisons[which];
  const std::vector<std::size_t> shown = telling(result, which);
  const std::size_t columns = 2 + comparison.against.size();
  Asked asked;
  asked.text = fmt::format("columns: {}\npanels:\n", columns);
  for (const std::size_t record : shown)
    add_panels(comparison, result.records[record], result.records[record].comparisons[which], request.records,
               asked);
  return picture(asked, shown.size() < result.records.size() ? "Worst, middle and best described record"
                                                             : "Record and model");
}

std::string curves_picture(const FitResult& result) {
  Asked asked;
  asked.text = fmt::format("columns: {}\npanels:\n", std::min<std::size_t>(2, result.curves.size()));
  for (const FittedCurve& curve : result.curves) {
    const std::string si = si_of(curve.dimension), unit = drawn_in(curve.unit);
    const std::string n = asked.add(
        {{"at", "", curve.at}, {"value", si, curve.value}, {"low", si, curve.low}, {"high", si, curve.high}});
    const std::string shade =
        curve.data_range.empty()
            ? ""
            : fmt::format(", shade: [{:.9g}, {:.9g}]", curve.data_range[0], curve.data_range[1]);
    asked.text += fmt::format(
        "  - {{plot: lines, x: at{0}, y: value{0}{1}, low: low{0}{1}, high: high{0}{1}, x_label: {2}, "
        "y_label: {3}{4}}}\n",
        n, unit, text_of(curve.label), text_of(curve.name), shade);
  }
  return picture(asked, "Fitted, with the 95 % interval; shaded where there are records");
}

std::string correlation_picture(const FitResult& result) {
  MatrixChart chart{"Correlation of what was found", {}, {}};
  for (const FittedNumber& number : result.numbers) chart.names.push_back(number.title());
  for (Eigen::Index i = 0; i < result.correlation.rows(); ++i) {
    const Eigen::RowVectorXd row = result.correlation.row(i);
    chart.values.emplace_back(row.begin(), row.end());
  }
  return draw(chart);
}

}  // namespace

std::vector<FitPicture> fit_pictures(const FitRequest& request, const FitResult& result) {
  std::vector<FitPicture> pictures;
  for (std::size_t i = 0; i < request.comparisons.size(); ++i)
    if (!telling(result, i).empty())
      pictures.push_back(
          {request.comparisons.size() == 1 ? "fit-records.svg" : fmt::format("fit-records-{}.svg", i + 1),
           records_picture(request, result, i)});
  const bool certain = result.correlation.rows() > 0;
  if (certain && !result.curves.empty()) pictures.push_back({"fit-curves.svg", curves_picture(result)});
  if (certain && result.numbers.size() > 1)
    pictures.push_back({"fit-correlation.svg", correlation_picture(result)});
  return pictures;
}

}  // namespace stepwire
