#include "engine/app/session/fitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/estimation/searches.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/plot/matrix_chart.hpp"
#include "engine/view/plot/plot_tools.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::session {

namespace {

estimation::FitRequest request_of(const LoadedModel& model, const FitCall& call) {
  estimation::FitRequest request = *model.fit;
  if (call.starts) request.starts = *call.starts;
  if (call.follow) request.follow = call.follow;
  if (call.seed) request.seed = *call.seed;
  return request;
}

/// Returns an estimate of the number of runs that the searches need.
double runs_of(const estimation::FitRequest& request) {
  constexpr double steps = 10.0;  // iterations of a search
  return steps * static_cast<double>((request.parameters.size() + 1) * request.starts);
}

struct FitParts : SearchParts {
  FitParts(const Registry& registry, const LoadedModel& model, const FitCall& call,
           const std::atomic<bool>* interrupt)
      : SearchParts(registry, model, call.engine, runs_of(request_of(model, call))),
        request(request_of(model, call)),
        source{loader, model.file, settings, used, interrupt} {}

  estimation::FitRequest request;
  estimation::ModelSource source;
};

std::string si_of(const std::optional<unit::Dimension>& dimension) {
  return dimension && *dimension != unit::Dimension{} ? unit::si_name(*dimension) : "";
}

/// Returns the indices of the worst, the median and the best record of a comparison. A constant record has no
/// agreement and counts as the best.
std::vector<std::size_t> telling(const estimation::FitResult& result, std::size_t comparison) {
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

/// Conversion of SI numbers to the unit of an axis.
struct DrawnUnit {
  unit::Unit unit{};
  std::string text;  ///< unit on axes; empty: unknown

  DrawnUnit(const std::string& given, const std::optional<unit::Dimension>& dimension)
      : text(given.empty() ? si_of(dimension) : given) {
    if (const auto parsed = unit::parse_unit(given); parsed && !given.empty()) unit = *parsed;
  }

  std::vector<double> of(std::vector<double> values) const {
    for (double& value : values) value = unit.from_si(value);
    return values;
  }
};

/// Record and model in one comparison.
struct ComparedRecord {
  const estimation::FitComparison& comparison;
  const estimation::FittedRecord& record;
  const estimation::ComparedRows& rows;
  const std::string& word;  ///< legend of the measured curve
  DrawnUnit unit{comparison.model.unit_text, comparison.model.formula.dimension};

  std::string title() const {
    return fmt::format("{}{}{}{}", record.label, record.label.empty() ? "" : ": ", agreement_text(rows),
                       record.held_out ? ", held out" : "");
  }
  std::vector<plot::NumberCurve> both(const std::vector<double>& x) const {
    return {{x, unit.of(rows.measured), word}, {x, unit.of(rows.model), "model"}};
  }
};

/// Adds record and model over the first 30 % of the time, so that single periods are visible.
void add_over_time(const ComparedRecord& compared, plot::FigureBuilder& panels) {
  const std::vector<double>& time = compared.rows.time;
  const double begin = time.front(), end = std::min(time.back(), begin + 0.3 * (time.back() - begin));
  plot::PlotBuilder& plot = panels.add({.title = compared.title(), .x = {.range = {{begin, end}}}});
  plot::name_axis(plot.spec.x, "time", "s");
  plot::name_axis(plot.spec.y, compared.comparison.model.label, compared.unit.text);
  plot::draw_curves(compared.both(time), plot);
  plot::set_line_ranges(plot);
}

void add_residual(const ComparedRecord& compared, plot::FigureBuilder& panels) {
  std::vector<double> residual = compared.rows.model;
  for (std::size_t i = 0; i < residual.size(); ++i) residual[i] -= compared.rows.measured[i];
  plot::PlotBuilder& plot = panels.add({});
  plot::name_axis(plot.spec.x, "time", "s");
  plot::name_axis(plot.spec.y, "residual", compared.unit.text);
  plot::draw_curves({{compared.rows.time, compared.unit.of(std::move(residual))}}, plot);
  plot::set_line_ranges(plot);
}

/// Adds record and model over the quantity that the file names, such as a hysteresis loop.
void add_loop(const ComparedRecord& compared, std::size_t which, plot::FigureBuilder& panels) {
  const query::Series& against = compared.comparison.against[which];
  const DrawnUnit unit(against.unit_text, against.formula.dimension);
  plot::PlotBuilder& plot = panels.add({});
  plot::name_axis(plot.spec.x, against.label, unit.text);
  plot::name_axis(plot.spec.y, compared.comparison.model.label, compared.unit.text);
  plot::draw_curves(compared.both(unit.of(compared.rows.against[which])), plot);
  plot.plane(0.05);
  plot.spec.x.zero_line = plot.spec.y.zero_line = true;
}

plot::FigureSpec records_figure(const estimation::FitRequest& request, const estimation::FitResult& result,
                                std::size_t which) {
  const estimation::FitComparison& comparison = request.comparisons[which];
  const std::vector<std::size_t> shown = telling(result, which);
  const std::size_t columns = 2 + comparison.against.size();
  plot::FigureBuilder panels(
      {.title = shown.size() < result.records.size() ? "Worst, middle and best described record"
                                                     : "Record and model",
       .columns = static_cast<int>(columns)},
      shown.size() * columns);
  for (const std::size_t record : shown) {
    const ComparedRecord compared{comparison, result.records[record],
                                  result.records[record].comparisons[which], request.records};
    add_over_time(compared, panels);
    add_residual(compared, panels);
    for (std::size_t i = 0; i < comparison.against.size(); ++i) add_loop(compared, i, panels);
  }
  return panels.finished();
}

void add_curve(const estimation::FittedCurve& curve, plot::FigureBuilder& panels) {
  const DrawnUnit unit(curve.unit, curve.dimension);
  plot::PlotBuilder& plot = panels.add({});
  plot::name_axis(plot.spec.x, curve.label, "");
  plot::name_axis(plot.spec.y, curve.name, unit.text);
  plot::draw_curves({{curve.at, unit.of(curve.value)}}, plot);
  plot::draw_band(plot::curves_of(plot.panel(), {curve.at, unit.of(curve.low), unit.of(curve.high)}).curves,
                  plot);
  plot::draw_spans(curve.data_range, plot);
  plot::set_line_ranges(plot);
}

plot::FigureSpec curves_figure(const estimation::FitResult& result) {
  plot::FigureBuilder panels({.title = "Fitted, with the 95 % interval; shaded where there are records",
                              .columns = static_cast<int>(std::min<std::size_t>(2, result.curves.size()))},
                             result.curves.size());
  for (const estimation::FittedCurve& curve : result.curves) add_curve(curve, panels);
  return panels.finished();
}

plot::FigureSpec correlation_figure(const estimation::FitResult& result) {
  plot::MatrixChart chart{"Correlation of what was found", {}, {}};
  for (const estimation::FittedNumber& number : result.numbers) chart.names.push_back(number.title());
  for (Eigen::Index i = 0; i < result.correlation.rows(); ++i) {
    const Eigen::RowVectorXd row = result.correlation.row(i);
    chart.values.emplace_back(row.begin(), row.end());
  }
  return plot::figure_of(chart);
}

}  // namespace

estimation::FitResult fit_model(const Registry& registry, const LoadedModel& model, const FitCall& call,
                                const Monitor& monitor) {
  FitParts parts(registry, model, call, monitor.interrupt);
  estimation::FitResult result =
      fit(parts.source, model.job, parts.request, {call.threads, monitor.progress, call.workers});
  result.file = model.file;
  monitor.note_interpreted(parts.code.take_problem());
  return result;
}

messages::ItemWork fit_work(const Registry& registry, const LoadedModel& model, const FitCall& call) {
  const auto parts = std::make_shared<FitParts>(registry, model, call, nullptr);
  const auto work =
      std::make_shared<estimation::SearchWork>(parts->source, model.job, parts->request, call.threads);
  return [parts, work](const messages::Item& item) { return work->work(item); };
}

/// Each start, from the request or from the global search, has a short first search and may have a continued
/// one.
std::size_t most_searches(const LoadedModel& model, const FitCall& call) {
  return 2 * (request_of(model, call).starts + 1);
}

std::string fit_key(const LoadedModel& model, const FitCall& call) {
  const estimation::FitRequest request = request_of(model, call);
  return fmt::format("{} {} {} {}", search_key(model), request.starts, request.follow.value_or(0),
                     request.seed);
}

LoadOptions with_fitted(LoadOptions options, const estimation::FitResult& result) {
  options.settings.insert(options.settings.end(), result.shared.begin(), result.shared.end());
  if (result.of_records.size() == 1)
    options.settings.insert(options.settings.end(), result.of_records[0].begin(), result.of_records[0].end());
  options.of_points = result.of_records;
  return options;
}

std::vector<std::string> write_fit(const std::string& folder, const LoadedModel& model,
                                   const estimation::FitResult& result) {
  io::write_file(folder + "/fit.json", result::json_of(result).text() + "\n");
  if (!result.numbers.empty()) io::write_file(folder + "/parameters.yaml", parameters_text(result));
  std::vector<std::string> names;
  for (const FitPicture& picture : fit_pictures(*model.fit, result)) {
    names.push_back(picture.name + ".svg");
    render::write_figure(folder, picture.name, picture.figure);
  }
  return names;
}

std::string agreement_text(const estimation::ComparedRows& rows, int width) {
  return std::isfinite(rows.agreement) ? fmt::format("{:{}.2f} %", rows.agreement, width)
                                       : "constant (no agreement in percent)";
}

std::string parameters_text(const estimation::FitResult& result) {
  std::string text = parameters_text("Found by a fit of", result.file, result.shared);
  for (std::size_t record = 0; record < result.of_records.size(); ++record)
    for (const diagram::Setting& setting : result.of_records[record])
      text += result.of_records.size() == 1 ? fmt::format("{}: {}\n", setting.name, setting.value)
                                            : fmt::format("# {}: {}  (in {})\n", setting.name, setting.value,
                                                          text::visible(result.records[record].label));
  return text;
}

std::vector<FitPicture> fit_pictures(const estimation::FitRequest& request,
                                     const estimation::FitResult& result) {
  std::vector<FitPicture> pictures;
  for (std::size_t i = 0; i < request.comparisons.size(); ++i)
    if (!telling(result, i).empty())
      pictures.push_back(
          {request.comparisons.size() == 1 ? "fit-records" : fmt::format("fit-records-{}", i + 1),
           records_figure(request, result, i)});
  const bool certain = result.correlation.rows() > 0;
  if (certain && !result.curves.empty()) pictures.push_back({"fit-curves", curves_figure(result)});
  if (certain && result.numbers.size() > 1)
    pictures.push_back({"fit-correlation", correlation_figure(result)});
  return pictures;
}

}  // namespace stepwire::session
