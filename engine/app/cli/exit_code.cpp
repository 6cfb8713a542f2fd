#include "engine/app/cli/exit_code.hpp"

namespace stepwire::cli {

ExitCode code_of(const session::Outcome& outcome) {
  if (outcome.result.interrupted) return ExitCode::interrupted;
  ExitCode code = outcome.result.faults.empty() ? ExitCode::done : ExitCode::wrong;
  for (const claim::Verdict& verdict : outcome.verdicts) {
    if (verdict.fails() && !outcome.early()) code = worst(code, ExitCode::fails);
    if (verdict.surprises()) code = worst(code, ExitCode::wrong);
  }
  return code;
}

ExitCode code_of(const estimation::FitResult& result) {
  if (result.interrupted) return ExitCode::interrupted;
  return result.refused ? ExitCode::wrong : ExitCode::done;
}

ExitCode code_of(const tuning::TuneResult& result) {
  if (result.interrupted) return ExitCode::interrupted;
  return result.feasible ? ExitCode::done : ExitCode::wrong;
}

}  // namespace stepwire::cli
