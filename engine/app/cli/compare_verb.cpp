#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/report/comparison_text.hpp"
#include "engine/app/report/junit_suites.hpp"
#include "engine/app/session/comparing.hpp"
#include "engine/app/session/fault_json.hpp"
#include "engine/base/io/file.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::cli {
namespace {

struct CompareWords {
  session::CompareCall runs;
  std::string picture;  ///< File of the overlay; empty: none.
  std::string junit;    ///< File for the signals as test cases; empty: none.
  bool json = false;
};

void write_picture(const std::string& file, const session::ComparedRuns& runs) {
  const render::PictureKind kind = render::picture_kind_of(file);
  render::require_converter({kind});
  io::write_file(file, render::converted(render::render(report::comparison_figure(runs)).svg, kind));
}

ExitCode compare(const CompareWords& words) {
  const session::ComparedRuns runs = session::compare_runs(words.runs);
  if (words.json)
    put_json(result::json_of(runs.difference));
  else
    put_report(report::comparison_text(runs.difference), !runs.difference.agrees);
  if (!words.picture.empty()) write_picture(words.picture, runs);
  if (!words.junit.empty()) report::write_junit(words.junit, {report::suite_of(runs.difference)});
  return runs.difference.agrees ? ExitCode::done : ExitCode::fails;
}

void add_tolerances(CLI::App& verb, session::CompareCall& call) {
  const auto add = [&](const char* name, std::vector<std::string>& words, const char* about,
                       const char* form) {
    verb.add_option(name, words, about)->allow_extra_args(false)->option_text(form);
  };
  add("--absolute", call.absolute, "accepted difference: 'force=0.1 N', or '0.1 N' of all", "[SIGNAL=]VALUE");
  add("--relative", call.relative, "accepted share of the largest absolute value in A: '1 %'",
      "[SIGNAL=]SHARE");
  add("--jitter", call.jitter, "time by which an edge may be earlier or later: '2 ms'", "[SIGNAL=]TIME");
  add("--hold", call.hold, "signals that keep each value up to the next row: 'gear*'", "SIGNAL");
  add("--only", call.only, "signals that are compared: 'rig.*'; without it all are", "SIGNAL");
  verb.add_option("--within", call.within, "YAML file with tolerances by signal, and with a baseline")
      ->option_text("FILE");
}

Action declare_compare(CLI::App& verb) {
  const auto words = std::make_shared<CompareWords>();
  session::CompareCall& call = words->runs;
  verb.add_option("RUN_A", call.a, "a folder of run --out, or a CSV, MAT or HDF5 file")->required();
  verb.add_option("RUN_B", call.b, "the other one; without it the file of --within names the baseline");
  add_tolerances(verb, call);
  verb.add_option("-o", words->picture, "picture of both runs and their differences, SVG, PNG or PDF");
  verb.add_option("--junit", words->junit, "file for the signals as test cases, in the XML that servers read")
      ->type_name("FILE");
  verb.add_flag("--json", words->json, "print the result as JSON");
  return [words](const Registry&) {
    json::Json faults;
    const ExitCode code = guarded([&] { return compare(*words); }, &faults);
    if (words->json && faults.is_list()) put_json(json::Json::object().set("faults", std::move(faults)));
    return code;
  };
}

}  // namespace

Verb compare_verb() {
  return {"compare", "compare two recorded runs, signal by signal",
          "Example:\n  stepwire compare baseline.csv out/lag --relative '1 %' --jitter 'gate=2 ms' -o "
          "compare.svg\n"
          "The exit code is 0 where they agree, 1 where they differ, and 2 where they cannot be compared.",
          declare_compare};
}

}  // namespace stepwire::cli
