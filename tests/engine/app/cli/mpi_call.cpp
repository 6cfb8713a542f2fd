#include "tests/engine/app/cli/mpi_call.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <map>
#include <sstream>
#include <thread>

#include "engine/base/io/resources.hpp"
#include "engine/base/subprocess/process.hpp"

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds longest{60};

/// Waits until something is so; a test that waits too long fails.
void await(const std::function<bool()>& is_so) {
  for (const auto end = Clock::now() + longest; !is_so();
       std::this_thread::sleep_for(std::chrono::milliseconds{5}))
    if (Clock::now() > end) FAIL("this has not come to pass");
}

/// True if a journal has a line after its head.
bool has_result(const std::string& journal) {
  const std::size_t line = journal.find('\n');
  return line != journal.npos && line + 1 < journal.size();
}

pid_t parent_of(pid_t process) {
  const std::string stat = content_of("/proc/" + std::to_string(process) + "/stat");
  const std::size_t behind = stat.rfind(") ");
  pid_t parent = 0;
  char state = 'Z';
  if (behind != stat.npos) std::istringstream(stat.substr(behind + 2)) >> state >> parent;
  return state == 'Z' ? 0 : parent;
}

/// All processes of the program whose words name a folder, with their parents.
std::map<pid_t, pid_t> processes_in(const std::string& folder) {
  std::map<pid_t, pid_t> found;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    const pid_t process = std::atoi(entry.path().filename().c_str());
    if (process == 0) continue;
    const std::string words = content_of(entry.path().string() + "/cmdline");
    if (!words.starts_with(std::string(STEPWIRE_PROGRAM) + '\0') || words.find(folder) == words.npos)
      continue;
    if (const pid_t parent = parent_of(process)) found[process] = parent;
  }
  return found;
}

MpiProcesses now_in(const std::string& folder) {
  const auto all = processes_in(folder);
  MpiProcesses processes;
  for (const auto& [process, parent] : all)
    if (all.contains(parent)) {
      processes.workers.push_back(process);
      processes.ranks.push_back(parent);
    }
  return processes;
}

}  // namespace

bool has_mpi() {
  if (!stepwire::io::find_resource("mpi").empty() && !stepwire::subprocess::find_program("mpirun").empty())
    return true;
  WARN("the program was built without MPI, or mpirun is not here; nothing was checked");
  return false;
}

Done run_by_three(const Scratch& folder, const std::vector<std::string>& words,
                  const std::function<void()>& meanwhile) {
  std::vector<std::string> command{"mpirun", "--allow-run-as-root", "--oversubscribe", "-np", "3",
                                   "--wdir", folder.path(""),       STEPWIRE_PROGRAM};
  command.insert(command.end(), words.begin(), words.end());
  command.insert(command.end(), {"--mpi", "--out", folder.path("shared")});
  stepwire::subprocess::ProcessResult result;
  {
    const std::jthread runs(
        [&] { result = stepwire::subprocess::run_process({.command = command, .limit = longest}); });
    if (meanwhile) meanwhile();
  }
  Done done;
  done.code = result.status;
  done.out = result.output;
  done.err = result.errors;
  return done;
}

MpiProcesses processes_at_work(const Scratch& folder, const std::string& journal) {
  const std::string file = folder.path("shared/" + journal);
  await([&] { return has_result(content_of(file)); });
  MpiProcesses processes;
  await([&] {
    processes = now_in(folder.path(""));
    return processes.workers.size() == 2;
  });
  return processes;
}
