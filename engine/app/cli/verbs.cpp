#include "engine/app/cli/verb.hpp"

namespace stepwire::cli {

// Each of these has a source file of its own: run_verb() is in run_verb.cpp.
Verb run_verb(), fit_verb(), tune_verb(), study_verb(), check_verb(), flatten_verb(), generate_verb(),
    draw_verb(), verify_verb(), loop_verb(), thesis_verb(), blocks_verb(), format_verb(), schema_verb(),
    lsp_verb(), studio_verb(), linearize_verb(), trim_verb(), help_verb(), completion_verb(), collect_verb(),
    job_verb(), statistics_verb(), compare_verb(), mutate_verb(), report_verb(), diff_verb(), merge_verb(),
    git_setup_verb(), fetch_verb(), import_verb(), mcp_verb(), devices_verb(), rig_verb(), io_verb(),
    realtime_check_verb();

const std::vector<Verb>& verbs() {
  static const std::vector<Verb> all{
      run_verb(),     studio_verb(),     fit_verb(),       tune_verb(),
      study_verb(),   statistics_verb(), linearize_verb(), trim_verb(),
      collect_verb(), job_verb(),        check_verb(),     diff_verb(),
      merge_verb(),   git_setup_verb(),  fetch_verb(),     import_verb(),
      flatten_verb(), generate_verb(),   draw_verb(),      verify_verb(),
      compare_verb(), mutate_verb(),     report_verb(),    loop_verb(),
      devices_verb(), rig_verb(),        io_verb(),        realtime_check_verb(),
      thesis_verb(),  blocks_verb(),     format_verb(),    schema_verb(),
      lsp_verb(),     mcp_verb(),        help_verb(),      completion_verb()};
  return all;
}

}  // namespace stepwire::cli
