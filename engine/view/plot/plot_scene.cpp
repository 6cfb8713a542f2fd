#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/run_rows.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire {
namespace {

/// The instants that a figure shows of the scene of its file.
struct ChosenInstants {
  std::shared_ptr<const Scene> scene;
  std::string file;
  Mark mark;
  std::vector<double> times;     ///< [s]; empty: the one instant of `where`
  std::optional<Formula> where;  ///< of several runs that with the first row for which this is true
  std::vector<std::string> words;
};

/// Reads the options; faults are gathered.
class InstantsReader {
 public:
  InstantsReader(const Node& node, const SymbolTable& names, Faults& faults)
      : node_(node), names_(names), faults_(faults) {}

  ChosenInstants read() {
    ChosenInstants instants{names_.scene, names_.file, node_.mark, {}, {}, {}};
    if (!instants.scene)
      fault(node_, "plot", "a plot 'scene' draws the section 'scene' of its file, and there is none");
    if (const Node* at = node_.find("at")) read_times(*at, instants);
    if (const Node* where = node_.find("where"))
      instants.where = read_formula(*where, names_, "figure.where", faults_);
    if (const Node* words = node_.find("words")) read_words(*words, instants);
    check_recording(instants);
    return instants;
  }

 private:
  void fault(const Node& node, const std::string& key, std::string message) {
    faults_.add({{names_.file, node.mark}, "figure." + key, std::move(message), {}});
  }

  void read_times(const Node& node, ChosenInstants& instants) {
    for (const Node& item : node.as_list()) {
      const auto time = read_number(item, names_, "figure.at", faults_);
      if (!time) continue;
      check_dimension(*time, Dimension{{0.0, 0.0, 1.0}}, "an instant", item, names_, "figure.at", faults_);
      const double stop = names_.diagram ? names_.diagram->diagram().stop : time->value;
      if (time->value < 0.0 || time->value > stop)
        fault(item, "at", fmt::format("{} is not within the run, which lasts {} s", item.text, stop));
      instants.times.push_back(time->value);
    }
  }

  void read_words(const Node& node, ChosenInstants& instants) {
    for (const Node& item : node.as_list())
      instants.words.push_back(read_text(item, names_, "figure.words", faults_));
    const std::size_t count = std::max<std::size_t>(1, instants.times.size());
    if (instants.words.size() != count)
      fault(node, "words", fmt::format("there are {} texts for {} instants", instants.words.size(), count));
  }

  void check_recording(const ChosenInstants& instants) {
    if (!instants.scene || !instants.where) return;
    std::vector<const Formula*> formulas{&*instants.where};
    for (const Formula& formula : instants.scene->formulas) formulas.push_back(&formula);
    common_recording(formulas, names_, node_, "figure.where", faults_);
  }

  const Node& node_;
  const SymbolTable& names_;
  Faults& faults_;
};

/// The row of the run whose time is nearest to that instant.
std::size_t row_at(double instant, const RunRows& rows, const std::vector<double>& time) {
  std::size_t nearest = rows.begin;
  for (std::size_t row = rows.begin; row < rows.end; ++row)
    if (std::abs(time[row] - instant) < std::abs(time[nearest] - instant)) nearest = row;
  return nearest;
}

SceneInstants drawn_instants(const ChosenInstants& instants, std::span<const Recording> recordings) {
  const Scene& scene = *instants.scene;
  const Recording& recording = recordings[scene.recording];
  const RunRows rows = rows_of_run(instants.where, recording);
  if (rows.none())
    throw Error(Fault{{instants.file, instants.mark}, "figure.where", "no row is left to be drawn", {}});
  const SceneView view = view_of(scene, recording);
  const std::vector<double>& time = recording.table.columns.front().values;
  std::vector<std::size_t> chosen;
  for (const double instant : instants.times) chosen.push_back(row_at(instant, rows, time));
  if (chosen.empty()) chosen.push_back(rows.first);
  std::vector<std::vector<SceneShape>> shapes;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    shapes.push_back(view.shapes(row_of(recording, chosen[i])));
    const std::string when = fmt::format("{} s", short_number(time[chosen[i]], 3));
    words.push_back(instants.words.empty() ? chosen.size() > 1 ? when : "" : instants.words[i] + ", " + when);
  }
  return {instants.scene, std::move(shapes), std::move(words)};
}

PanelContent read_instants(const Node& node, const SymbolTable& names, Faults& faults) {
  return [instants = InstantsReader(node, names, faults).read()](std::span<const Recording> recordings) {
    return drawn_instants(instants, recordings);
  };
}

}  // namespace

PlotKind scene_plot() {
  PlotKind kind;
  kind.name = "scene";
  kind.doc = "instants of the section `scene` side by side, as whoever is at the device sees them";
  kind.options = {
      {"at", "times of the instants: 2 s, or a list", form::one_or_list(form::number())},
      {"words", "texts below the instants, in their order", form::one_or_list(form::text())},
      {"where",
       "of several runs that with the first row for which this is true; without `at` that row is drawn",
       form::tree()}};
  kind.plane = false;
  kind.read = read_instants;
  return kind;
}

}  // namespace stepwire
