#include "engine/app/session/fitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/estimation/searches.hpp"
#include "engine/app/session/matrix_json.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/plot/matrix_chart.hpp"
#include "engine/view/plot/plot_tools.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::session {

using json::Json;

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

Json number_json(const estimation::FittedNumber& number) {
  Json json = Json::object().set("name", number.name);
  if (!number.record.empty()) json.set("record", number.record);
  return json.set("value", number.value)
      .set("unit", number.dimension ? Json(unit::si_name(*number.dimension)) : Json())
      .set("start", number.start)
      .set("standard_error", number.standard_error)
      .set("standard_error_classical", number.classical_error)
      .set("standard_error_serial", number.serial_error)
      .set("interval", Json::list({number.low, number.high}))
      .set("at_bound", number.at_bound);
}

Json agreements_json(const estimation::FittedRecord& record) {
  Json list = Json::list();
  for (const estimation::ComparedRows& rows : record.comparisons)
    list.push(std::isfinite(rows.agreement) ? Json(rows.agreement) : Json());
  return list;
}

Json records_json(const estimation::FitResult& result) {
  Json list = Json::list();
  for (const estimation::FittedRecord& record : result.records)
    list.push(Json::object()
                  .set("record", record.label)
                  .set("held_out", record.held_out)
                  .set("rows", record.rows)
                  .set("fit", agreements_json(record)));
  return list;
}

Json starts_json(const estimation::FitResult& result) {
  Json list = Json::list();
  for (const estimation::FittedStart& start : result.starts)
    list.push(Json::object()
                  .set("cost", start.cost)
                  .set("finished", start.finished)
                  .set("iterations", start.iterations));
  return list;
}

/// Returns the fitted curves in SI.
Json curves_json(const estimation::FitResult& result) {
  Json list = Json::list();
  for (const estimation::FittedCurve& curve : result.curves)
    list.push(Json::object()
                  .set("curve", curve.name)
                  .set("unit", curve.dimension ? Json(unit::si_name(*curve.dimension)) : Json())
                  .set("at", Json::list_of(curve.at))
                  .set("value", Json::list_of(curve.value))
                  .set("low", Json::list_of(curve.low))
                  .set("high", Json::list_of(curve.high))
                  .set("data_range", Json::list_of(curve.data_range)));
  return list;
}

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
  io::write_file(folder + "/fit.json", fit_json(model, result).text() + "\n");
  if (!result.numbers.empty()) io::write_file(folder + "/parameters.yaml", parameters_text(model, result));
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

Json fit_json(const LoadedModel& model, const estimation::FitResult& result) {
  Json numbers = Json::list();
  for (const estimation::FittedNumber& number : result.numbers) numbers.push(number_json(number));
  return Json::object()
      .set("file", model.file)
      .set("parameters", std::move(numbers))
      .set("correlation", matrix_json(result.correlation))
      .set("cost", result.cost)
      .set("deviation", result.deviation)
      .set("degrees_of_freedom", result.freedom)
      .set("standard_errors",
           result.standard_errors == estimation::StandardErrors::serial ? "serial" : "classical")
      .set("rows_in_time", result.in_time)
      .set("residuals_together", static_cast<std::size_t>(result.together))
      .set("records", records_json(result))
      .set("curves", curves_json(result))
      .set("starts", starts_json(result))
      .set("findings", Json::list_of(result.findings))
      .set("converged", result.converged)
      .set("limited", result.limited)
      .set("interrupted", result.interrupted)
      .set("compiled", result.compiled)
      .set("in_part", result.in_part)
      .set("duration", result.seconds);
}

std::string parameters_text(const LoadedModel& model, const estimation::FitResult& result) {
  std::string text = fmt::format("# Found by a fit of {}; stepwire run FILE --set-from takes this file.\n",
                                 text::visible(model.file));
  for (const diagram::Setting& setting : result.shared)
    text += fmt::format("{}: {}\n", setting.name, setting.value);
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
