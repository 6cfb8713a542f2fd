#include "engine/app/report/study_text.hpp"

#include <fmt/format.h>

#include "engine/analyse/study/study_tables.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/text/count.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::report {

std::string study_text(const session::LoadedModel& model, const study::Experiments& experiments) {
  const study::StudyRequest& request = *model.study;
  std::size_t trials = 0;
  for (const study::Experiment& experiment : experiments) trials += experiment.trials.size();
  std::string result =
      fmt::format("study: task {}, {}, {} ({}){}\n", request.task,
                  text::counted(request.subject_names().size(), "subject"), text::counted(trials, "trial"),
                  study::whose_trials(request),
                  experiments.size() == 1 ? "" : fmt::format(", {} studies of a sweep", experiments.size()));
  for (const study::Experiment& experiment : experiments)
    for (const std::string& remark : experiment.remarks)
      result +=
          fmt::format("  note {}{}{}\n", text::visible(remark), experiment.sets.empty() ? "" : "; with ",
                      text::visible(run::settings_text(experiment.sets)));
  for (const query::NamedTable& one : model.tables)
    if (one.name == "means" || one.name == "significance" ||
        (one.name.starts_with("experiments") && request.experiments > 1))
      result += "\n" + text::text(*one.table);
  return result + "\n";
}

}  // namespace stepwire::report
