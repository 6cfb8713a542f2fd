#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/simulate/record/recording.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/plot/figure_spec.hpp"

namespace stepwire::testing {

/// A square of 4 mm about the origin with a hole of 2 mm.
inline Outline square_outline() {
  const auto square = [](double half, double sense) {
    Outline::Line line;
    for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}})
      line.points.push_back({half * x, half * sense * y, 0.0});
    return line;
  };
  return {false, {square(2e-3, 1.0), square(1e-3, -1.0)}};
}

/// Names for the figures and claims of the tests: x [m], v [m/s], f [N] in one recording, slow [N] in
/// another.
inline query::SymbolTable sample_names() {
  const unit::Dimension metre{{1}}, second{{0, 0, 1}}, ampere{{0, 0, 0, 1}}, newton{{1, 1, -2}};
  return {"d.yaml",
          {{"time", second, {}},
           {"current", ampere, {}},
           {"rig.x", metre, 0},
           {"rig.v", metre / second, 0},
           {"push.force", newton, 0},
           {"slow", newton, 1}},
          {{"limit", 0.35}, {"low", -2.0}, {"reach", 0.1, metre}},
          {"rig.x", "e", "motor", "wide"},
          "",
          nullptr,
          {{"map", square_outline()}, {"ball", {true, {{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}}}}}}};
}

inline table::Column column(std::string name, std::string unit, std::vector<double> values) {
  return {std::move(name), std::move(unit), std::move(values)};
}

/// Runs of one period of x = sin(2 pi t) mm with the force 3 + 10 current N, one for each current.
inline record::Recording sample_recording(const std::vector<double>& currents, int rows) {
  record::Recording recording;
  recording.starts.clear();
  auto& columns = recording.table.columns;
  columns = {column("time", "s", {}), column("current", "A", {}), column("rig.x", "m", {}),
             column("rig.v", "m/s", {}), column("push.force", "N", {})};
  constexpr double turn = 6.283185307179586;
  for (const double current : currents) {
    recording.starts.push_back(columns[0].values.size());
    for (int i = 0; i <= rows; ++i) {
      const double t = static_cast<double>(i) / rows;
      const double row[] = {t, current, 1e-3 * std::sin(turn * t), 1e-3 * turn * std::cos(turn * t),
                            3.0 + 10.0 * current};
      for (std::size_t k = 0; k < 5; ++k) columns[k].values.push_back(row[k]);
    }
  }
  return recording;
}

inline std::vector<record::Recording> sample_recordings(const std::vector<double>& currents, int rows) {
  record::Recording slow;
  slow.table.columns = {column("time", "s", {0.0, 1.0}), column("current", "A", {0.0, 0.0}),
                        column("slow", "N", {1.0, 2.0})};
  return {sample_recording(currents, rows), slow};
}

inline std::string all_text(const yaml::Faults& faults) {
  std::string text;
  for (const auto& fault : faults.list()) text += fault.text() + "\n";
  return text;
}

/// The claims of a text; what is wrong in it as one string.
struct ReadClaims {
  std::vector<claim::Claim> claims;
  std::string faults;
};

inline ReadClaims claims_of(const std::string& text) {
  const yaml::Document document = yaml::parse_document(text, "d.yaml");
  yaml::Faults faults;
  auto claims = claim::read_claims(document.root, claim::Claim::Kind::statement, sample_names(), faults);
  return {std::move(claims), all_text(faults)};
}

struct ReadFigures {
  std::vector<plot::Figure> figures;
  std::string faults;
};

inline ReadFigures figures_of(const std::string& text) {
  const yaml::Document document = yaml::parse_document(text, "d.yaml");
  yaml::Faults faults;
  auto figures = plot::read_figures(document.root, sample_names(), faults);
  return {std::move(figures), all_text(faults)};
}

/// The first panel of a figure without faults.
inline plot::Panel panel_of(const std::string& text) {
  const auto read = figures_of(text);
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  return read.figures.at(0).panels.at(0);
}

/// The figure that a text makes of a recording with these currents.
inline plot::FigureSpec figure_spec_of(const std::string& text, const std::vector<double>& currents = {0.0},
                                       int rows = 40) {
  const auto read = figures_of(text);
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  return plot::figure_spec(read.figures.at(0), sample_recordings(currents, rows));
}

/// The plot of its first panel.
inline plot::PlotSpec spec_of(const std::string& text, const std::vector<double>& currents = {0.0},
                              int rows = 40) {
  return std::get<plot::PlotSpec>(figure_spec_of(text, currents, rows).panels.at(0).content);
}

/// The i-th mark, which is of this type.
template <class MarkType>
const MarkType& mark(const plot::PlotSpec& plot, std::size_t index) {
  REQUIRE(index < plot.marks.size());
  REQUIRE(std::holds_alternative<MarkType>(plot.marks[index]));
  return std::get<MarkType>(plot.marks[index]);
}

}  // namespace stepwire::testing
