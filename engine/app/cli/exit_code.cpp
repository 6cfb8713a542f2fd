#include "engine/app/cli/exit_code.hpp"

#include <algorithm>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string_view>

#include "engine/app/cli/console.hpp"
#include "engine/app/session/fault_json.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/text/characters.hpp"

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
  if (result.refused) return ExitCode::wrong;
  return result.converged ? ExitCode::done : ExitCode::fails;
}

ExitCode code_of(const tuning::TuneResult& result) {
  if (result.interrupted) return ExitCode::interrupted;
  if (!result.feasible) return ExitCode::wrong;
  return result.converged ? ExitCode::done : ExitCode::fails;
}

void print_faults(const run::RunResult& result) {
  constexpr std::size_t max_shown = 10;
  const auto& faults = result.faults;
  for (std::size_t i = 0; i < std::min(faults.size(), max_shown); ++i)
    complain("{}\n", faults[i].fault.text());
  if (faults.size() > max_shown)
    complain("and {} more runs of the sweep ended early\n", faults.size() - max_shown);
}

/// Returns the code and the text of an exception that no fault of a diagram is. A symbolic link that leads to
/// itself is a bad file of the user.
static std::pair<ExitCode, std::string> described(const std::exception& error) {
  const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
  if (!of_file || of_file->code() != std::errc::too_many_symbolic_link_levels)
    return {ExitCode::surroundings, error.what()};
  return {ExitCode::wrong,
          text::visible(of_file->path1().string()) + ": is a symbolic link that leads to itself"};
}

ExitCode guarded(const std::function<ExitCode()>& action, json::Json* faults) {
  const auto refused = [&](std::string_view why, ExitCode code) {
    complain("{}\n", why);
    if (faults) *faults = json::Json::list({json::Json::object().set("text", std::string(why))});
    return code;
  };
  try {
    return action();
  } catch (const yaml::Error& error) {
    complain("{}\n", error.what());
    if (faults) *faults = session::faults_json(error.faults());
    return ExitCode::wrong;
  } catch (const table::TableError& error) {
    return refused(text::visible(error.what()), ExitCode::wrong);
  } catch (const subprocess::ProcessStopped&) {
    return ExitCode::interrupted;
  } catch (const std::length_error&) {  // requested container size exceeds the address space
    return refused("this run needs more memory than there can be", ExitCode::surroundings);
  } catch (const std::bad_alloc&) {
    return refused(
        "there is not enough memory for this run; record fewer signals or give 'record' an 'every'",
        ExitCode::surroundings);
  } catch (const std::exception& error) {  // EnvironmentError, std::system_error and others
    const auto [code, why] = described(error);
    return refused(why, code);
  }
}

}  // namespace stepwire::cli
