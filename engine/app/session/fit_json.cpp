// JSON of a fit.
#include <fmt/format.h>

#include <cmath>

#include "engine/app/session/fitting.hpp"
#include "engine/app/session/matrix_json.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::session {

using json::Json;

namespace {

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

}  // namespace

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

}  // namespace stepwire::session
