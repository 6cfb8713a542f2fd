#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/monitoring.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/report/junit_suites.hpp"
#include "engine/app/thesis/thesis_figures.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::cli {
namespace {

void summarise(const std::vector<gallery::GalleryEntry>& entries) {
  for (const gallery::GalleryEntry& entry : entries)
    for (const claim::Verdict& verdict : entry.verdicts)
      if (!verdict.holds)
        put_failure(fmt::format("{}: {}: {}: {} ({})\n", text::visible(entry.folder), verdict.word(),
                                text::visible(verdict.that), text::visible(verdict.shown),
                                text::visible(verdict.check)));
}

/// Prints the faults of a figure and returns its exit code.
ExitCode reported(const thesis::ThesisFigure& figure) {
  return guarded([&] {
    if (figure.error) std::rethrow_exception(figure.error);
    print_faults(figure.outcome.result);
    return code_of(figure.outcome);
  });
}

/// Returns the claims of a figure as test cases.
junit::TestSuite suite_of_figure(const thesis::ThesisFigure& figure) {
  try {
    if (figure.error) std::rethrow_exception(figure.error);
    return report::suite_of(figure.entry.folder, figure.outcome.seconds, figure.entry.verdicts,
                            figure.outcome.result);
  } catch (const std::exception& error) {
    return report::suite_of_fault(figure.entry.folder, error.what());
  }
}

/// Options of the verb.
struct ThesisWords {
  thesis::ThesisCall call;
  std::string junit;  ///< File for the claims as test cases; empty: none.
};

ExitCode thesis(const ThesisWords& words, const Registry& registry) {
  const thesis::ThesisCall& call = words.call;
  std::vector<junit::TestSuite> suites;
  const EndDelay delay(EndDelay::Signals::first);
  ExitCode code = ExitCode::done;
  const std::vector<gallery::GalleryEntry> entries = [&] {
    Progress progress("thesis");
    return thesis::make_thesis(call, registry, terminal_monitor(&progress),
                               [&](const thesis::ThesisFigure& figure) {
                                 code = worst(code, reported(figure));
                                 suites.push_back(suite_of_figure(figure));
                               });
  }();
  std::ranges::sort(suites, {}, &junit::TestSuite::name);  // they are made in any order
  if (!words.junit.empty()) report::write_junit(words.junit, suites);
  summarise(entries);
  say("{} diagram files; see {}/index.html\n{}\n", entries.size(), call.out,
      gallery::gallery_verdict(entries));
  return interrupted() ? ExitCode::interrupted : code;
}

Action declare_thesis(CLI::App& verb) {
  const auto call = std::make_shared<ThesisWords>();
  verb.add_option("--only", call->call.only, "beginnings of file names, e.g. fig15,fig31")->delimiter(',');
  verb.add_option("--out", call->call.out, "folder of the page")->capture_default_str();
  verb.add_option("--junit", call->junit, "file for the claims as test cases, in the XML that servers read")
      ->type_name("FILE");
  return [call](const Registry& registry) {
    call->call.diagrams = io::resource("diagrams") + "/thesis";
    return thesis(*call, registry);
  };
}

}  // namespace

Verb thesis_verb() {
  return {"thesis", "make the figures of the thesis and a page that shows them",
          "Example:\n  stepwire thesis --only fig15,fig31 --out out/thesis", declare_thesis};
}

}  // namespace stepwire::cli
