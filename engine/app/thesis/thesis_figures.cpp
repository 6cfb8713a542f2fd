#include "engine/app/thesis/thesis_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/app/session/fitting.hpp"
#include "engine/app/session/kept_experiments.hpp"
#include "engine/app/session/run_files.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/app/thesis/thesis_contents.hpp"
#include "engine/app/thesis/thesis_data.hpp"
#include "engine/app/thesis/thesis_entry.hpp"
#include "engine/app/thesis/thesis_print.hpp"
#include "engine/base/hash/hash.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/replay/replay_folder.hpp"

namespace stepwire::thesis {

namespace {

namespace fs = std::filesystem;

constexpr const char* not_made = "was interrupted before it was made";

bool wanted(const std::string& stem, const std::vector<std::string>& only) {
  return only.empty() || std::any_of(only.begin(), only.end(),
                                     [&](const std::string& start) { return stem.starts_with(start); });
}

std::vector<fs::path> figure_files(const ThesisCall& call) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(call.diagrams, error))
    if (entry.path().extension() == ".yaml" && wanted(entry.path().stem().string(), call.only))
      files.push_back(entry.path());
  if (error) throw io::EnvironmentError(fmt::format("{}: {}", call.diagrams, error.message()));
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw yaml::Error(
        yaml::Fault{{call.diagrams, {}},
                    "",
                    fmt::format("no diagram file here begins with {}", fmt::join(call.only, " or ")),
                    {}});
  return files;
}

/// Returns the folder of the experiment journals, from which a repeated call continues.
std::string kept_folder(const ThesisCall& call) {
  return (fs::path(call.out) / "experiments").string();
}

io::OwnedFolder::Files kept_files(const ThesisCall& call) {
  io::OwnedFolder::Files files;
  std::error_code error;
  for (const auto& file : fs::recursive_directory_iterator(kept_folder(call), error))
    files.insert(file.path().string());
  return files;
}

/// Maker of the figures, several at a time; each entry has the index of its file.
class Maker {
 public:
  Maker(const ThesisCall& call, const Registry& registry, const session::Monitor& monitor,
        const std::function<void(const ThesisFigure&)>& made)
      : call_(call), registry_(registry), monitor_(monitor), made_(made), files_(figure_files(call)) {
    figures_.resize(files_.size());
    for (std::size_t i = 0; i < files_.size(); ++i) {
      gallery::GalleryEntry& entry = figures_[i].entry;
      entry.title = entry.folder = files_[i].stem().string();
      entry.error = not_made;
    }
  }

  void run() {
    const std::size_t count =
        std::min<std::size_t>(files_.size(), std::max(1u, std::thread::hardware_concurrency()));
    const auto others = parallel::begin_threads(count, [this] { work(); });
    work();
  }

  /// Returns the entries in the order of the thesis.
  std::vector<gallery::GalleryEntry> entries(const ThesisContents& contents) const {
    std::vector<gallery::GalleryEntry> entries;
    for (const ThesisFigure& figure : figures_) entries.push_back(figure.entry);
    std::ranges::stable_sort(entries, {}, [&](const auto& entry) { return contents.place_of(entry); });
    return entries;
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < files_.size() && !monitor_.interrupted(); i = next_++) {
      make(files_[i], figures_[i]);
      const std::lock_guard lock(mutex_);
      made_(figures_[i]);
      monitor_.show(static_cast<double>(++done_) / static_cast<double>(files_.size()),
                    files_[i].stem().string());
    }
  }

  void make(const fs::path& file, ThesisFigure& figure) {
    figure.entry.sources = {source_of(file.string(), root())};
    try {
      fill(file, figure);
    } catch (const subprocess::ProcessStopped&) {
      figure.error = std::current_exception();
    } catch (const std::exception& error) {
      const std::string_view reason = error.what();
      figure.entry.error = reason.substr(0, reason.find('\n'));
      figure.error = std::current_exception();
    }
  }

  void fill(const fs::path& file, ThesisFigure& figure) {
    gallery::GalleryEntry& entry = figure.entry;
    const std::string folder = (fs::path(call_.out) / file.stem()).string();
    session::LoadedModel model = session::load_model(registry_, file.string(), {});
    std::vector<std::string> fitted;
    if (model.fit) fitted = fit_first(model, folder);
    describe_entry(model, entry);
    entry.sources = sources_of(model, root());
    session::Outcome outcome = model.study ? study(model, folder) : run(model, folder);
    if (!outcome.result.interrupted) {
      entry.verdicts = outcome.verdicts;
      std::vector<std::string> pictures =
          session::write_outputs(folder, model, outcome, {session::FileKind::csv});
      pictures.insert(pictures.end(), fitted.begin(), fitted.end());
      add_pictures(model, pictures, call_.out, entry);
      add_downloads(call_.out, entry);
      entry.error = outcome.result.faults.empty() ? "" : outcome.result.faults.front().fault.message.text();
    }
    outcome.result.recordings.clear();
    outcome.shown.clear();
    figure.outcome = std::move(outcome);
  }

  /// Returns the folder that contains the diagram files and their parts.
  std::string root() const { return fs::path(call_.diagrams).parent_path().string(); }

  session::Outcome run(const session::LoadedModel& model, const std::string& folder) const {
    replay::write_replay(folder, model.job);
    run::RunOptions options;
    options.interrupt = monitor_.interrupt;
    options.observers = monitor_.observers;
    // Figures are made in parallel. The last ones, fewer than the cores, run with several threads each.
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    options.threads = next_ + cores < files_.size() ? 1 : 0;
    return session::run_model(model, options);
  }

  session::Outcome study(session::LoadedModel& model, const std::string& folder) {
    session::StudyCall call;
    call.kept = fmt::format("{}/{}", kept_folder(call_), hash::hash_of(session::experiments_note(model)));
    const auto experiments = studies_.experiments(registry_, model, call, quiet());
    session::Outcome outcome = session::study_outcome(model, *experiments);
    if (!outcome.result.interrupted) session::write_study(folder, model, *experiments, outcome);
    return outcome;
  }

  /// Fits and reloads the model with the fitted values. Returns the names of the pictures.
  std::vector<std::string> fit_first(session::LoadedModel& model, const std::string& folder) const {
    session::FitCall call;
    call.threads = 1;
    const estimation::FitResult result = session::fit_model(registry_, model, call, quiet());
    const std::vector<std::string> pictures = session::write_fit(folder, model, result);
    if (!result.interrupted && !result.refused)
      model = session::load_model(registry_, model.file, session::with_fitted(model.options, result));
    return pictures;
  }

  /// Returns a monitor without progress display; progress counts whole figures.
  session::Monitor quiet() const { return {monitor_.interrupt, {}, {}, monitor_.observers}; }

  const ThesisCall& call_;
  const Registry& registry_;
  const session::Monitor& monitor_;
  const std::function<void(const ThesisFigure&)>& made_;
  std::vector<fs::path> files_;
  std::vector<ThesisFigure> figures_;
  std::atomic<std::size_t> next_ = 0;
  std::size_t done_ = 0;
  std::mutex mutex_;
  session::Studies studies_;
};

void write_gallery(const std::string& out, const ThesisContents& contents,
                   const std::vector<gallery::GalleryEntry>& entries) {
  for (const auto& [place, text] :
       gallery::gallery_files({contents.title, contents.introduction, entries, contents.summaries}))
    io::write_file((fs::path(out) / place).string(), text);
}

}  // namespace

std::vector<gallery::GalleryEntry> make_thesis(const ThesisCall& call, const Registry& registry,
                                               const session::Monitor& monitor,
                                               const std::function<void(const ThesisFigure&)>& made) {
  const ThesisContents contents = read_contents(call.diagrams);
  Maker maker(call, registry, monitor, made);
  const io::OwnedFolder folder(call.out, [&] { return kept_files(call); });
  maker.run();
  std::vector<gallery::GalleryEntry> entries = maker.entries(contents);
  pack_data(call.out, entries);
  if (!monitor.interrupted()) print_chapters(call.out, entries);
  write_gallery(call.out, contents, entries);
  return entries;
}

}  // namespace stepwire::thesis
