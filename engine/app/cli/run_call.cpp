#include "engine/app/cli/run_call.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/mpi_run.hpp"
#include "engine/app/cli/run_file.hpp"
#include "engine/app/cluster/relay.hpp"
#include "engine/app/report/junit_suites.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/temporary.hpp"
#include "engine/base/messages/worker_process.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {

using json::Json;

namespace {

namespace fs = std::filesystem;

/// Runs tar. Throws EnvironmentError with the first line of its errors.
void make(const std::vector<std::string>& command) {
  try {
    subprocess::run_helper("tar", {.command = command});
  } catch (const io::EnvironmentError& error) {
    const std::string words = error.what();
    throw io::EnvironmentError(words.substr(0, words.find('\n')));
  }
}

/// Writes a tar archive of a folder to the standard output, by way of the temporary `file`.
/// Entries are sorted by name and have no times and owners, so equal files give equal bytes. Throws
/// EnvironmentError.
void put_archive(const std::string& folder, const std::string& file) {
  std::vector<std::string> command{
      "tar",         "--create",   "--format=gnu", "--file=" + file, "--directory=" + folder,
      "--sort=name", "--mtime=@0", "--owner=0",    "--group=0",      "--numeric-owner",
      "--"};
  const std::size_t options = command.size();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    command.push_back(entry.path().filename().string());
  std::sort(command.begin() + static_cast<std::ptrdiff_t>(options), command.end());
  if (command.size() == options) return;  // no run has written a file
  make(command);
  std::ifstream archive(file, std::ios::binary);
  std::array<char, 1 << 16> block;
  while (archive.read(block.data(), block.size()) || archive.gcount() > 0)
    put_data({block.data(), static_cast<std::size_t>(archive.gcount())});
  if (!archive.eof()) io::refuse_file(file, errno);
}

/// True if each file has an output folder of its own. Files of one name from different folders would
/// overwrite each other's results.
bool folders_differ(const RunCall& call) {
  std::map<std::string, std::string> files;
  for (const std::string& file : call.models.files) {
    const auto [first, is_new] = files.emplace(folder_of(call, file), file);
    if (is_new || call.out.empty()) continue;
    complain("{} and {} would both be written to {}; give each a call with its own --out\n", first->second,
             file, first->first);
    return false;
  }
  return true;
}

/// True if at most one of --json, --csv - and --out - uses the standard output, and --csv has a single file.
bool output_is_single(const RunCall& call) {
  std::vector<std::string> takers;
  if (call.models.json) takers.emplace_back("--json");
  if (call.csv == standard_output) takers.emplace_back("--csv -");
  if (call.out == standard_output) takers.emplace_back("--out -");
  const bool table_of_many = !call.csv.empty() && call.models.files.size() > 1;
  if (takers.size() > 1)
    complain("{} would mix on the standard output; give one of them a name\n", fmt::join(takers, " and "));
  if (table_of_many)
    complain("--csv is a single table; give each of the {} files a call of its own\n",
             call.models.files.size());
  return takers.size() < 2 && !table_of_many;
}

ExitCode run_each(const RunCall& call, const Registry& registry, MpiRun* mpi = nullptr) {
  if (!folders_differ(call)) return ExitCode::wrong;
  session::Session session(registry);
  session.use_device(call.device);
  return each_model(call.models, registry, [&](session::LoadedModel& model, Json& results) {
    if (!call.models.json) print_notes(model);
    const std::size_t suites = call.suites ? call.suites->size() : 0;
    const ExitCode code = run_file(call, session, model, results, mpi);
    if (call.suites && call.suites->size() == suites)  // a fit failed, or a share was run
      call.suites->push_back(report::suite_of_fault(model.file, "no whole run was made"));
    return code;
  });
}

/// Runs a file on the processes of mpirun. Each process forks a worker before MPI starts, so the death of a
/// worker does not end the process. Only process 0 writes and prints.
ExitCode run_by_mpi(const RunCall& call, const Registry& registry) {
  if (call.models.files.size() != 1) {
    complain("--mpi runs one file; give each file a call of its own\n");
    return ExitCode::wrong;
  }
  messages::WorkerProcess worker;
  if (worker.is_worker()) return work_for(worker.other(), call, registry);
  const std::unique_ptr<messages::Messages> messages = messages::open_mpi();
  if (messages->rank() > 0) {
    cluster::relay(*messages, worker);
    messages->finish();
    return ExitCode::done;
  }
  worker.end();
  MpiRun mpi(*messages);
  MpiRun* const shared = mpi.shares() ? &mpi : nullptr;
  return mpi.finish(guarded([&] { return run_each(call, registry, shared); }));
}

/// Runs the files into a temporary folder and writes it as an archive to the standard output.
ExitCode run_into_archive(RunCall call, const Registry& registry) {
  if (::isatty(STDOUT_FILENO) == 1) {
    complain(
        "--out - writes a tar archive, which is nothing for a terminal; put it into a file: ... --out - "
        ">runs.tar\n");
    return ExitCode::wrong;
  }
  const subprocess::ScratchFolder scratch;
  call.archive = true;
  call.out = scratch.path() + "/runs";
  io::require_folder(call.out);
  const ExitCode code = run_each(call, registry);
  put_archive(call.out, scratch.path() + "/runs.tar");
  return code;
}

/// Returns the message about a word that is none of the names, which are "csv, mat, ...".
yaml::Message unknown_kind(const std::string& word, const std::string& names) {
  std::vector<std::string> all;
  std::istringstream list(names);
  for (std::string name; list >> name;) all.push_back(name.substr(0, name.find(',')));
  return fmt::format("does not take '{}'", word) +
         yaml::did_you_mean(word, all, "It takes: " + names + "; several are separated by commas");
}

/// Splits a list of words, separated by commas, and removes duplicates. `kind_of` returns std::nullopt for an
/// unknown word.
template <class KindOf>
auto kinds_of(const std::string& option, const std::string& list, const std::string& names,
              const KindOf& kind_of) {
  std::vector<typename decltype(kind_of(list))::value_type> kinds;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    const std::string word = list.substr(at, end - at);
    const auto kind = kind_of(word);
    if (!kind) throw CLI::ValidationError(option, unknown_kind(word, names).text());
    if (std::ranges::find(kinds, *kind) == kinds.end()) kinds.push_back(*kind);
    at = end + 1;
  }
  return kinds;
}

}  // namespace

void add_kinds_options(CLI::App& verb, std::optional<session::FileKinds>& of_files,
                       render::PictureKinds& of_pictures) {
  const std::string files = session::file_kind_names(), pictures = render::picture_kind_names();
  CLI::Option* const out = verb.get_option("--out");  // these options have no effect without --out
  verb.add_option_function<std::string>(
          "--files",
          [&of_files, files](const std::string& list) {
            of_files = kinds_of("--files", list, files, session::file_kind);
          },
          fmt::format(
              "kinds of files for the recorded signals in --out, of {}; left out: csv,mat, and h5 for "
              "more than {:.0f} million numbers, of which no csv is written",
              files, session::most_numbers_of_csv * 1e-6))
      ->needs(out)
      ->option_text("KIND,...");
  verb.add_option_function<std::string>(
          "--pictures",
          [&of_pictures, pictures](const std::string& list) {
            of_pictures = kinds_of("--pictures", list, pictures, render::picture_kind);
          },
          fmt::format("kinds of pictures of figures in --out, of {}; left out: svg", pictures))
      ->needs(out)
      ->option_text("KIND,...");
}

void add_run_options(CLI::App& verb, RunCall& call, const std::string& out) {
  add_model_options(verb, call.models);
  add_engine_option(verb, call.engine,
                    "interpreted, compiled, or auto: compiled once that is worth it; all to the same bits");
  verb.add_option("--out", call.out, out + "; - writes them as a tar archive to the standard output")
      ->type_name("DIR");
  add_kinds_options(verb, call.files, call.pictures);
  verb.add_flag(
      "--mpi", call.mpi,
      "the processes of mpirun share points of a sweep, people and experiments of a study, searches "
      "of a fit or a tuning");
}

/// Runs the files and writes their claims as test cases, those of files that cannot be run as errors.
static ExitCode run_with_report(RunCall call, const Registry& registry) {
  const auto suites = std::make_shared<std::vector<junit::TestSuite>>();
  const std::string file = std::exchange(call.junit, "");
  call.suites = suites;
  call.models.refused = [suites](const std::string& name, const std::string& fault) {
    suites->push_back(report::suite_of_fault(name, fault));
  };
  const ExitCode code = run_models(call, registry);
  return worst(code, guarded([&] {
                 report::write_junit(file, *suites);
                 return ExitCode::done;
               }));
}

ExitCode run_models(const RunCall& call, const Registry& registry) {
  if (!call.junit.empty()) return run_with_report(call, registry);
  if (!output_is_single(call)) return ExitCode::wrong;
  console_style().data_only = call.csv == standard_output || call.out == standard_output;
  if (call.mpi) return guarded([&] { return run_by_mpi(call, registry); });
  return call.out == standard_output ? run_into_archive(call, registry) : run_each(call, registry);
}

}  // namespace stepwire::cli
