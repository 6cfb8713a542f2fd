#include "engine/app/session/row_use.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/claim/judge.hpp"
#include "engine/app/session/sweep_sections.hpp"
#include "engine/simulate/run/memory.hpp"
#include "engine/view/plot/last_rows.hpp"

namespace stepwire::session {

namespace {

/// Part of a file or call that needs the rows of all runs at once, with an alternative that does not.
struct Need {
  yaml::Place place;
  std::string subject, what, cure;
};

bool keeps_rows(const LoadedModel& model) {
  const auto& sweep = model.job.plan.diagram.sweep;
  return !model.job.points.empty() && !model.study && !model.kept && sweep->keep == diagram::Sweep::Keep::rows;
}

void add_claims(const LoadedModel& model, std::vector<Need>& needs) {
  for (const claim::Claim& claim : model.claims)
    if (claim.recording < recordings_of(model) && claim::keeps_rows(claim))
      needs.push_back({claim.place, "claims", fmt::format("'{}'", claim.check),
                       "judge a number of each run, by 'each_run: true', 'quantile_of_runs' or 'fraction_of_runs'"});
}

void add_pictures(const LoadedModel& model, std::vector<Need>& needs) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  const std::string numbers =
      "draw numbers of the runs, which 'sweep: {keep: {peak: max(x)}}' makes, or their last rows ('rows: final')";
  const yaml::Node& figures = diagram.figure;
  for (std::size_t i = 0; i < model.figures.size(); ++i) {
    const bool reads = std::ranges::any_of(model.figures[i].panels, [&](const plot::Panel& panel) {
      return plot::rows_read(panel, recordings_of(model)) == plot::RowsRead::all;
    });
    if (reads)
      needs.push_back({{diagram.file, figures.is_list() ? figures.items[i].mark : figures.mark},
                       "figure", "the picture", numbers});
  }
  if (model.scene) needs.push_back({{diagram.file, diagram.scene.mark}, "scene", "its animation", numbers});
}

void add_tables(const LoadedModel& model, const RowUse& use, std::vector<Need>& needs) {
  const yaml::Place place{model.file, {}};
  const bool are_runs = use.folder.empty() || std::ranges::all_of(use.files, has_runs);
  if (!are_runs) needs.push_back({place, "--files", "a table of kind csv or mat", "give --files h5"});
  if (use.table) needs.push_back({place, "--csv", "a table", "give --out DIR --files h5"});
}

std::vector<Need> needs_of(const LoadedModel& model, const RowUse& use) {
  std::vector<Need> needs;
  add_claims(model, needs);
  if (!use.folder.empty()) add_pictures(model, needs);
  add_tables(model, use, needs);
  return needs;
}

}  // namespace

bool goes_run_by_run(const LoadedModel& model, const RowUse& use) {
  return keeps_rows(model) && needs_of(model, use).empty();
}

void require_rows(const LoadedModel& model, const RowUse& use) {
  if (!keeps_rows(model)) return;
  const auto lack = run::lack_for_all_rows(model.job);
  if (!lack) return;
  yaml::Faults faults;
  for (const Need& need : needs_of(model, use))
    faults.add({need.place, need.subject,
                yaml::Message(fmt::format("{} needs the rows of all runs at once, and {}", need.what, *lack),
                              fmt::format("{}, or give 'record' an 'every'", need.cure)),
                {}});
  faults.throw_if_any();
}

}  // namespace stepwire::session
