#pragma once

#include <string>
#include <vector>

#include "engine/app/session/monitor.hpp"
#include "engine/app/session/mutations.hpp"
#include "engine/base/result/record.hpp"

namespace stepwire::session {

/// Outcome of a mutation.
enum class MutationOutcome {
  noticed,   ///< A claim fails, or the run ends with a fault.
  survives,  ///< All claims hold as before.
  refused    ///< No version of it can be run.
};

/// Mutation that was tried.
struct TriedMutation {
  Mutation::Kind kind = Mutation::Kind::parameter;
  std::string what, old, version;
  MutationOutcome outcome = MutationOutcome::survives;
  std::string by{};  ///< First claim that fails, the fault of the run, or the refusal.
};

/// Mutations of a file, and what its claims notice: `mutate`.
struct MutationResult {
  std::string file{};
  std::size_t claims = 0;
  std::vector<TriedMutation> mutations{};
  std::vector<std::string> left_out{};  ///< own parameters without mutations, each with the reason
  bool interrupted = false;

  std::size_t count(MutationOutcome outcome) const;
  std::size_t noticed() const { return count(MutationOutcome::noticed); }
  std::size_t survived() const { return count(MutationOutcome::survives); }
  std::size_t refused() const { return count(MutationOutcome::refused); }
};

/// Tries all mutations of a file on `threads` threads (0: all cores). Throws Error for a file without claims,
/// with a study or a fit, or whose claims do not hold as it is.
MutationResult mutate(const Registry& registry, const std::string& file, const LoadOptions& options,
                      const Monitor& monitor, unsigned threads = 0);

/// Declares the fields of the result of `mutate --json`.
void declare(result::Record<MutationResult>& is);

}  // namespace stepwire::session
