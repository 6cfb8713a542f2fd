#include <fmt/format.h>

#include "engine/app/cli/commands.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/recorded_study.hpp"
#include "engine/app/cli/report.hpp"
#include "engine/simulate/replay/verify.hpp"

namespace stepwire {

namespace {

/// Trials that were recorded cannot be replayed; they are analysed again.
ExitCode verify_analysis(const std::string& folder, const Registry& registry) {
  const std::string difference = verify_recorded(folder, registry);
  say("{}\n", difference.empty() ? folder + ": errors and tables of the recorded trials: all bits agree"
                                 : difference);
  return difference.empty() ? ExitCode::done : ExitCode::fails;
}

ExitCode verify_folder(const std::string& folder, const Registry& registry) {
  if (has_recorded(folder, registry)) return verify_analysis(folder, registry);
  const Verification verification = verify(folder, registry, &interrupted());
  if (verification.interrupted) return ExitCode::interrupted;
  if (verification.difference.empty()) {
    say("{}: {}\n", folder, verification_text(verification));
    return ExitCode::done;
  }
  say("{}\n", verification_text(verification));
  return ExitCode::fails;
}

}  // namespace

ExitCode verify_folders(const VerifyCommand& command, const Registry& registry) {
  const EndDelay delay(EndDelay::Signals::first);
  ExitCode code = ExitCode::done;
  for (const std::string& folder : command.folders) {
    if (interrupted()) break;
    code = worst(code, guarded([&] { return verify_folder(folder, registry); }));
  }
  return interrupted() ? ExitCode::interrupted : code;
}

}  // namespace stepwire
