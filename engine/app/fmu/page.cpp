#include "engine/app/fmu/page.hpp"

#include <fmt/format.h>

#include "engine/app/fmu/element.hpp"
#include "engine/app/fmu/units.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::fmu {

namespace {

using svg::markup_escaped;

std::string numbers_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : " ") + xml_number(number);
  return text;
}

std::string rows_of(const std::vector<Variable>& variables, const std::string& causality) {
  std::string rows;
  for (const Variable& variable : variables)
    if (variable.causality == causality)
      rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                          markup_escaped(variable.name), markup_escaped(unit_name(variable)),
                          numbers_text(variable.start), markup_escaped(variable.about));
  return rows;
}

std::string table(const std::vector<Variable>& variables, const std::string& causality,
                  const std::string& title) {
  const std::string rows = rows_of(variables, causality);
  if (rows.empty()) return "";
  return fmt::format(
      "<h2>{}</h2>\n<table>\n<tr><th>name</th><th>unit</th><th>start</th><th></th></tr>\n{}</table>\n", title,
      rows);
}

std::string exchange_text(const UnitAbout& about, const std::string& no_exchange) {
  return about.exchange
             ? "<p>By model exchange a solver of the importer integrates its states.</p>\n"
             : fmt::format("<p>There is no model exchange: {}.</p>\n", markup_escaped(no_exchange));
}

std::string fixed_text(const std::vector<codegen::FixedParameter>& fixed) {
  if (fixed.empty()) return "";
  std::string items;
  for (const codegen::FixedParameter& one : fixed)
    items += fmt::format("<li>{}: {}</li>\n", markup_escaped(one.name), markup_escaped(one.reason));
  return "<h2>Parameters that keep their value</h2>\n<ul>\n" + items + "</ul>\n";
}

}  // namespace

std::string unit_page(const UnitAbout& about, const std::vector<Variable>& variables,
                      const std::vector<codegen::FixedParameter>& fixed, const std::string& no_exchange,
                      bool drawn) {
  const std::string title = markup_escaped(about.title.empty() ? about.name : about.title);
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>{0}</title></head>\n"
             "<body>\n<h1>{0}</h1>\n{1}<p>A unit of FMI {2}, made by {3}. All numbers are SI.</p>\n"
             "<p>By co-simulation it makes whole numbers of steps of {4} s, with the bits of the diagram's "
             "own run; "
             "outputs follow from the inputs that were set last.</p>\n",
             title, drawn ? "<p><img src=\"diagram.svg\" alt=\"the diagram\"></p>\n" : "", about.version,
             markup_escaped(about.made_by), xml_number(about.step)) +
         exchange_text(about, no_exchange) +
         "<p>Directional derivatives are differences to both sides, not exact.</p>\n" +
         table(variables, "parameter", "Parameters") + table(variables, "input", "Inputs") +
         table(variables, "output", "Outputs") + fixed_text(fixed) + "</body>\n</html>\n";
}

}  // namespace stepwire::fmu
