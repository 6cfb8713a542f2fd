#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <thread>
#include <utility>

#include "engine/app/cli/commands.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/fitting.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/output.hpp"
#include "engine/app/cli/progress.hpp"
#include "engine/app/cli/report.hpp"
#include "engine/app/cli/studying.hpp"
#include "engine/app/cli/thesis_entry.hpp"
#include "engine/app/cli/thesis_print.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/view/gallery/gallery.hpp"

namespace stepwire {

namespace {

namespace fs = std::filesystem;

constexpr const char* not_made = "was interrupted before it was made";

bool wanted(const std::string& stem, const std::vector<std::string>& only) {
  return only.empty() || std::any_of(only.begin(), only.end(),
                                     [&](const std::string& start) { return stem.starts_with(start); });
}

std::vector<fs::path> figure_files(const ThesisCommand& command) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(command.diagrams, error))
    if (entry.path().extension() == ".yaml" && wanted(entry.path().stem().string(), command.only))
      files.push_back(entry.path());
  if (error) throw SurroundingsError(fmt::format("{}: {}", command.diagrams, error.message()));
  std::sort(files.begin(), files.end());
  return files;
}

/// Makes the figures, several at a time; each entry stands at its file's place.
class Maker {
 public:
  Maker(const ThesisCommand& command, const Registry& registry, std::vector<fs::path> files)
      : command_(command),
        registry_(registry),
        files_(std::move(files)),
        entries_(files_.size()),
        codes_(files_.size(), ExitCode::done) {
    for (std::size_t i = 0; i < files_.size(); ++i) {
      entries_[i].title = entries_[i].folder = files_[i].stem().string();
      entries_[i].error = not_made;
    }
  }

  void run() {
    const std::size_t count =
        std::min<std::size_t>(files_.size(), std::max(1u, std::thread::hardware_concurrency()));
    const auto others = begin_threads(count, [this] { work(); });
    work();
  }

  /// In the order of the thesis.
  std::vector<GalleryEntry> entries() const {
    std::vector<GalleryEntry> entries = entries_;
    std::ranges::stable_sort(entries, {}, place_of);
    return entries;
  }
  ExitCode code() const {
    ExitCode code = ExitCode::done;
    for (ExitCode one : codes_) code = worst(code, one);
    return code;
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < files_.size() && !interrupted(); i = next_++) {
      codes_[i] = make(files_[i], entries_[i]);
      progress_.show(static_cast<double>(++done_) / static_cast<double>(files_.size()),
                     files_[i].stem().string());
    }
  }

  ExitCode make(const fs::path& file, GalleryEntry& entry) {
    entry.sources = {source_of(file.string(), root())};
    return guarded([&] {
      try {
        return fill(file, entry);
      } catch (const ProcessStopped&) {
        throw;
      } catch (const std::exception& error) {
        const std::string_view reason = error.what();
        entry.error = reason.substr(0, reason.find('\n'));
        throw;
      }
    });
  }

  ExitCode fill(const fs::path& file, GalleryEntry& entry) {
    const std::string folder = (fs::path(command_.out) / file.stem()).string();
    Work work = prepare(registry_, file.string(), {});
    std::vector<std::string> fitted;
    if (work.fit) fitted = fit_first(work, folder);
    describe_entry(work, entry);
    entry.sources = sources_of(work, root());
    const Outcome outcome = work.study ? study(work, folder) : run(work, folder);
    print_faults(outcome.result);
    if (outcome.result.interrupted) return outcome.code;
    entry.verdicts = outcome.verdicts;
    std::vector<std::string> pictures = write_outputs(folder, work, outcome);
    pictures.insert(pictures.end(), fitted.begin(), fitted.end());
    add_pictures(work, pictures, command_.out, entry);
    add_downloads(command_.out, entry);
    entry.error = outcome.result.faults.empty() ? "" : outcome.result.faults.front().fault.message;
    return outcome.code;
  }

  /// What diagram files and their parts lie in.
  std::string root() const { return fs::path(command_.diagrams).parent_path().string(); }

  Outcome run(const Work& work, const std::string& folder) const {
    write_replay(folder, work.job);
    RunOptions options;
    options.interrupt = &interrupted();
    // The figures themselves are made in parallel, until no more of them wait than there are cores.
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    options.threads = next_ + cores < files_.size() ? 1 : 0;
    return carry_out(work, options);
  }

  Outcome study(Work& work, const std::string& folder) {
    const auto experiments = studies_.experiments(registry_, work, {}, {});
    Outcome outcome = carry_out_study(work, *experiments);
    if (outcome.result.interrupted) return outcome;
    write_study(folder, work, *experiments, outcome);
    return outcome;
  }

  /// The names of its pictures.
  std::vector<std::string> fit_first(Work& work, const std::string& folder) const {
    FitWords words;
    words.threads = 1;
    GeneratedCode code;
    const FitResult result = fit_quietly(registry_, work, {}, words, worth_compiling(work) ? &code : nullptr);
    const std::vector<std::string> pictures = write_fit(folder, work, result);
    if (code_of(result) == ExitCode::done) work = prepare(registry_, work.file, with_fitted({}, result));
    return pictures;
  }

  const ThesisCommand& command_;
  const Registry& registry_;
  std::vector<fs::path> files_;
  std::vector<GalleryEntry> entries_;
  std::vector<ExitCode> codes_;
  std::atomic<std::size_t> next_ = 0, done_ = 0;
  Studies studies_;
  Progress progress_{"thesis"};
};

void summarise(const std::vector<GalleryEntry>& entries) {
  for (const GalleryEntry& entry : entries)
    for (const Verdict& verdict : entry.verdicts)
      if (!verdict.holds)
        say("{}: {}: {}: {} ({})\n", visible(entry.folder), verdict.word(), visible(verdict.that),
            visible(verdict.shown), visible(verdict.check));
}

constexpr const char* introduction =
    "Every picture was computed by the diagram file on its page. Claims are checked on the recorded signals: "
    "what "
    "the thesis says of a figure, and what its pictures are said to show; invariants are what must hold "
    "throughout: limits, energy, safety.";

/// Where the front page is.
std::string write_gallery(const std::string& out, std::vector<GalleryEntry> entries) {
  for (const auto& [place, text] :
       gallery_files({"The thesis, figure by figure", introduction, std::move(entries)}))
    write_file((fs::path(out) / place).string(), text);
  return (fs::path(out) / "index.html").string();
}

}  // namespace

ExitCode run_thesis(const ThesisCommand& command, const Registry& registry) {
  return guarded([&] {
    const auto files = figure_files(command);
    if (files.empty()) {
      complain("no diagram file in {} begins with {}\n", command.diagrams, fmt::join(command.only, " or "));
      return ExitCode::wrong;
    }
    const OwnedFolder folder(command.out);
    const EndDelay delay(EndDelay::Signals::first);
    Maker maker(command, registry, files);
    maker.run();
    std::vector<GalleryEntry> entries = maker.entries();
    summarise(entries);
    if (!interrupted()) print_chapters(command.out, entries);
    const std::string page = write_gallery(command.out, entries);
    say("{} diagram files; see {}\n{}\n", files.size(), page, gallery_verdict(entries));
    return interrupted() ? ExitCode::interrupted : maker.code();
  });
}

}  // namespace stepwire
