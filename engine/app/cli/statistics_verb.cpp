#include <CLI/CLI.hpp>
#include <memory>

#include "engine/analyse/study/scores.hpp"
#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire::cli {

using json::Json;

namespace {

struct StatisticsCall {
  std::string file;
  study::ScoresRequest scores;
  std::string sums = "partial";
  bool power = false;
  std::uint64_t seed = 1;
  std::string out;  ///< folder; empty: no files
  bool json = false;
};

std::string tables_text(const study::ScoresAnalysis& analysis) {
  std::string all;
  for (const text::TextTable& table : study::score_tables(analysis))
    all += (all.empty() ? "" : "\n") + text::text(table);
  return all;
}

ExitCode analyse(const StatisticsCall& call) {
  study::ScoresRequest request = call.scores;
  if (call.power) request.power_seed = call.seed;
  request.sums = call.sums == "sequential"     ? statistics::SumsOfSquares::sequential
                 : call.sums == "hierarchical" ? statistics::SumsOfSquares::hierarchical
                                               : statistics::SumsOfSquares::partial;
  const study::ScoresAnalysis analysis = study::analyse_scores(call.file, std::move(request));
  const Json json = study::scores_json(call.file, analysis);
  const std::string tables = tables_text(analysis);
  if (!call.out.empty()) {
    io::write_file(call.out + "/statistics.json", json.text() + "\n");
    io::write_file(call.out + "/tables.txt", tables);
  }
  call.json ? put_json(json) : put_text(tables);
  if (!call.out.empty() && !call.json) say("  written to {}\n", call.out);
  return ExitCode::done;
}

void add_statistics_options(CLI::App& verb, StatisticsCall* call) {
  verb.add_option("FILE", call->file, "a CSV file with a score in each row and the levels of its factors")
      ->required();
  verb.add_option("--score", call->scores.score, "column of the scores; the last one without it");
  verb.add_option("--factors", call->scores.factors, "columns of the factors; all others without it")
      ->delimiter(',')
      ->expected(1, -1);
  CLI::Option* const subject =
      verb.add_option("--subject", call->scores.subject,
                      "column of the subjects, for repeated measures; none: independent scores");
  verb.add_flag("--additive", call->scores.additive, "main effects alone, of independent scores")
      ->excludes(subject);
  verb.add_option("--sums", call->sums,
                  "sums of squares of independent scores: sequential (type I), hierarchical "
                  "(II) or partial (III); partial without it")
      ->check(choice({"sequential", "hierarchical", "partial"}))
      ->excludes(subject);
  verb.add_flag("--power", call->power, "also the power of comparisons within subjects, by simulation");
  verb.add_option("--seed", call->seed, "of that simulation")->check(CLI::Range(0, 1'000'000'000));
}

Action declare_statistics(CLI::App& verb) {
  const auto call = std::make_shared<StatisticsCall>();
  add_statistics_options(verb, call.get());
  verb.add_option("--out", call->out, "folder for statistics.json and tables.txt");
  verb.add_flag("--json", call->json, "print the result as JSON");
  return [call](const Registry&) {
    Json faults;
    const ExitCode code = guarded([&] { return analyse(*call); }, &faults);
    if (call->json && faults.is_list())
      put_json(Json::object().set("file", call->file).set("faults", std::move(faults)));
    return code;
  };
}

}  // namespace

Verb statistics_verb() {
  return {"statistics", "analyse a table of scores: analysis of variance, repeated measures, comparisons",
          "Example:\n  stepwire statistics errors.csv --score error --factors device,task --subject person",
          declare_statistics};
}

}  // namespace stepwire::cli
