#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/run_rows.hpp"
#include "engine/base/text/count.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {

using yaml::form;

namespace {

/// Instants of the scene that a figure shows.
struct ChosenInstants {
  std::shared_ptr<const scene::Scene> scene;
  std::string file;
  yaml::Mark mark;
  std::vector<double> times;            ///< [s]; empty: the one instant of `where`
  std::optional<query::Formula> where;  ///< of several runs, selects that of the first true row
  std::vector<std::string> words;
};

using InstantsTable = yaml::KeyTable<ChosenInstants, query::NamesReading>;

void read_times(ChosenInstants& instants, const yaml::Node& node, const query::NamesReading& read) {
  for (const yaml::Node& item : node.as_list()) {
    const auto time = read.number(item, form::number("s"));
    if (!time) continue;
    const double stop = read.names.diagram ? read.names.diagram->diagram().stop : *time;
    if (*time < 0.0 || *time > stop)
      read.fault(item.mark, fmt::format("{} is not within the run, which lasts {} s", item.text, stop));
    instants.times.push_back(*time);
  }
}

/// Reads the words, one for each time; requires the times.
void read_words(ChosenInstants& instants, const yaml::Node& node, const query::NamesReading& read) {
  for (const yaml::Node& item : node.as_list()) instants.words.push_back(read.text(item));
  const std::size_t count = std::max<std::size_t>(1, instants.times.size());
  if (instants.words.size() != count)
    read.fault(node.mark, fmt::format("{} for {}", text::there_are(instants.words.size(), "text"),
                                      text::counted(count, "instant")));
}

const InstantsTable& instants_table() {
  static const InstantsTable table(
      "a picture of the scene", "{at: 2 s}",
      {{"at", "times of the instants: 2 s, or a list", form::one_or_list(form::number("s")), read_times},
       {"words", "texts below the instants, in their order", form::one_or_list(form::text()), read_words},
       {"where",
        "of several runs that with the first row for which this is true; without `at` that row is drawn",
        form::expression(), &ChosenInstants::where}});
  return table;
}

ChosenInstants read_chosen(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  ChosenInstants instants{names.scene, names.file, node.mark, {}, {}, {}};
  const query::NamesReading read("figure", names, faults);
  if (!instants.scene)
    yaml::below(read, "plot")
        .fault(node.mark, "a plot 'scene' draws the section 'scene' of its file, and there is none");
  yaml::set_keys(node, instants_table().rows, instants, read);
  if (!instants.scene || !instants.where) return instants;
  std::vector<const query::Formula*> formulas{&*instants.where};
  for (const query::Formula& formula : instants.scene->formulas) formulas.push_back(&formula);
  query::common_recording(formulas, names, node, "figure.where", faults);
  return instants;
}

/// Returns the row of the run with the nearest time.
std::size_t row_at(double instant, const query::RunRows& rows, const std::vector<double>& time) {
  std::size_t nearest = rows.begin;
  for (std::size_t row = rows.begin; row < rows.end; ++row)
    if (std::abs(time[row] - instant) < std::abs(time[nearest] - instant)) nearest = row;
  return nearest;
}

SceneInstants drawn_instants(const ChosenInstants& instants, std::span<const record::Recording> recordings) {
  const scene::Scene& scene = *instants.scene;
  const record::Recording& recording = recordings[scene.recording];
  const query::RunRows rows = query::rows_of_run(instants.where, recording);
  if (rows.none())
    throw yaml::Error(
        yaml::Fault{{instants.file, instants.mark}, "figure.where", "no row is left to be drawn", {}});
  const scene::SceneView view = scene::view_of(scene, recording);
  const std::vector<double>& time = recording.table.columns.front().values;
  std::vector<std::size_t> chosen;
  for (const double instant : instants.times) chosen.push_back(row_at(instant, rows, time));
  if (chosen.empty()) chosen.push_back(rows.first);
  std::vector<std::vector<scene::SceneShape>> shapes;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    shapes.push_back(view.shapes(scene::row_of(recording, chosen[i])));
    const std::string when = fmt::format("{} s", query::short_number(time[chosen[i]], 3));
    words.push_back(instants.words.empty() ? chosen.size() > 1 ? when : "" : instants.words[i] + ", " + when);
  }
  return {instants.scene, std::move(shapes), std::move(words)};
}

PanelContent read_instants(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  return [instants = read_chosen(node, names, faults)](std::span<const record::Recording> recordings) {
    return drawn_instants(instants, recordings);
  };
}

}  // namespace

PlotKind scene_plot() {
  PlotKind kind;
  kind.name = "scene";
  kind.doc = "instants of the section `scene` side by side, as whoever is at the device sees them";
  for (const yaml::Key& key : instants_table().form.of) kind.options.push_back(described_key(key));
  kind.plane = false;
  kind.read = read_instants;
  return kind;
}

}  // namespace stepwire::plot
