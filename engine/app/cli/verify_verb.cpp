#include <CLI/CLI.hpp>
#include <memory>

#include "engine/analyse/kept/kept_numbers.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/session/kept_experiments.hpp"
#include "engine/app/session/recorded_study.hpp"
#include "engine/app/session/rejudging.hpp"
#include "engine/app/studio/live/live_folder.hpp"
#include "engine/simulate/replay/verify.hpp"

namespace stepwire::cli {
namespace {

/// Computes the claims and tables of a folder again, after its signals agree.
ExitCode verify_claims(const std::string& folder, const Registry& registry) {
  const session::Rejudged claims = session::rejudge(folder, registry, {&interrupted(), {}, {}, {}});
  if (claims.interrupted) return ExitCode::interrupted;
  if (!claims.note.empty()) say("{}: {}\n", folder, claims.note);
  if (!claims.left_out.empty())
    say("{}: claims and tables are not computed again: {}\n", folder, claims.left_out);
  if (claims.difference.empty()) return ExitCode::done;
  put_failure(claims.difference + "\n");
  return ExitCode::fails;
}

/// Verifies a folder of recorded trials by repeating their analysis, because trials of persons cannot be
/// replayed.
ExitCode verify_analysis(const std::string& folder, const Registry& registry) {
  const std::string difference = session::verify_recorded(folder, registry);
  const std::string agree = folder + ": errors and tables of the recorded trials: all bits agree";
  put_report((difference.empty() ? agree : difference) + "\n", !difference.empty());
  return difference.empty() ? ExitCode::done : ExitCode::fails;
}

ExitCode verify_folder(const std::string& folder, const Registry& registry) {
  if (session::has_recorded(folder, registry)) return verify_analysis(folder, registry);
  const bool live = live::is_live_folder(folder);
  const replay::Verification verification =
      live ? live::verify_live(folder, registry, &interrupted())
           : replay::verify(folder, registry, &interrupted(), kept::numbers_of_folder);
  if (verification.interrupted) return ExitCode::interrupted;
  if (verification.difference.empty()) {
    say("{}: {}\n", folder, replay::verification_text(verification));
    if (const std::string others = session::not_replayed(folder); !others.empty())
      say("{}: {}\n", folder, others);
    return live ? ExitCode::done : verify_claims(folder, registry);
  }
  put_failure(replay::verification_text(verification) + "\n");
  return ExitCode::fails;
}

ExitCode verify_folders(const std::vector<std::string>& folders, const Registry& registry) {
  const EndDelay delay(EndDelay::Signals::first);
  ExitCode code = ExitCode::done;
  for (const std::string& folder : folders) {
    if (interrupted()) break;
    code = worst(code, guarded([&] { return verify_folder(folder, registry); }));
  }
  return interrupted() ? ExitCode::interrupted : code;
}

Action declare_verify(CLI::App& verb) {
  const auto folders = std::make_shared<std::vector<std::string>>();
  verb.add_option("RUN_DIR", *folders, "folders that run --out wrote")->required();
  return [folders](const Registry& registry) { return verify_folders(*folders, registry); };
}

}  // namespace

Verb verify_verb() {
  return {"verify", "replay what a run left, and compare it bit by bit",
          "Example:\n  stepwire run lag.yaml --out out/lag && stepwire verify out/lag", declare_verify};
}

}  // namespace stepwire::cli
