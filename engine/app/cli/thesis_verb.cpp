#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/monitoring.hpp"
#include "engine/app/cli/verb.hpp"
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
ExitCode report(const thesis::ThesisFigure& figure) {
  return guarded([&] {
    if (figure.error) std::rethrow_exception(figure.error);
    print_faults(figure.outcome.result);
    return code_of(figure.outcome);
  });
}

ExitCode thesis(const thesis::ThesisCall& call, const Registry& registry) {
  const EndDelay delay(EndDelay::Signals::first);
  ExitCode code = ExitCode::done;
  const std::vector<gallery::GalleryEntry> entries = [&] {
    Progress progress("thesis");
    return thesis::make_thesis(
        call, registry, terminal_monitor(&progress),
        [&](const thesis::ThesisFigure& figure) { code = worst(code, report(figure)); });
  }();
  summarise(entries);
  say("{} diagram files; see {}/index.html\n{}\n", entries.size(), call.out,
      gallery::gallery_verdict(entries));
  return interrupted() ? ExitCode::interrupted : code;
}

Action declare_thesis(CLI::App& verb) {
  const auto call = std::make_shared<thesis::ThesisCall>();
  verb.add_option("--only", call->only, "beginnings of file names, e.g. fig15,fig31")->delimiter(',');
  verb.add_option("--out", call->out, "folder of the page")->capture_default_str();
  return [call](const Registry& registry) {
    call->diagrams = io::resource("diagrams") + "/thesis";
    return thesis(*call, registry);
  };
}

}  // namespace

Verb thesis_verb() {
  return {"thesis", "make the figures of the thesis and a page that shows them",
          "Example:\n  stepwire thesis --only fig15,fig31 --out out/thesis", declare_thesis};
}

}  // namespace stepwire::cli
