#include "engine/app/thesis/thesis_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "engine/app/session/fitting.hpp"
#include "engine/app/session/kept_experiments.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/run_files.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/app/thesis/thesis_contents.hpp"
#include "engine/app/thesis/thesis_data.hpp"
#include "engine/base/hash/hash.hpp"
#include "engine/base/io/cache.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/view/gallery/gallery_picture.hpp"
#include "engine/view/plot/plot_kind.hpp"
#include "engine/view/render/pdf_outline.hpp"

namespace stepwire::thesis {
namespace {

namespace fs = std::filesystem;

std::string label_of(const diagram::Diagram& diagram) {
  std::string label;
  if (diagram.reproduces.figure) label = fmt::format("Figure {}", *diagram.reproduces.figure);
  if (diagram.reproduces.table)
    label += fmt::format("{}Table {}", label.empty() ? "" : " and ", *diagram.reproduces.table);
  return label;
}

/// Returns a picture that is not one of the file's figures, titled by its file name.
gallery::GalleryPicture extra_picture(const std::string& file) {
  static const std::map<std::string, std::string> words{
      {"scene.svg", "The scene in motion"},
      {"fit-records.svg", "Records and the fitted model"},
      {"fit-curves.svg", "Curves of the fitted model"},
      {"fit-correlation.svg", "Correlation of the fitted parameters"}};
  gallery::GalleryPicture picture;
  picture.title = words.contains(file) ? words.at(file) : fs::path(file).stem().string();
  picture.alt = picture.title;
  picture.own = true;
  return picture;
}

gallery::GalleryPicture picture_of(const plot::Figure& figure) {
  gallery::GalleryPicture picture;
  picture.caption = figure.caption;
  picture.alt = gallery::described(figure);
  picture.own = figure.own;
  picture.dense = figure.panels.size() == 1 && figure.panels.front().kind->name == "diagram";
  return picture;
}

/// Adds an assumption once, even if several instances of a part contain it.
void add_assumption(const diagram::DiagramParameter& parameter,
                    std::vector<gallery::Assumption>& assumptions) {
  const auto short_name = [](const std::string& name) { return name.substr(name.rfind('.') + 1); };
  const auto is_same = [&](const gallery::Assumption& known) {
    return short_name(known.name) == short_name(parameter.name) && known.value == parameter.text &&
           known.doc == parameter.doc;
  };
  if (std::ranges::none_of(assumptions, is_same))
    assumptions.push_back({parameter.name, parameter.text, parameter.doc});
}

/// Fills in the entry from the diagram file: label, title, captions, departures, assumed values.
void describe_entry(const session::LoadedModel& model, gallery::GalleryEntry& entry) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  entry.label = label_of(diagram);
  entry.figure = diagram.reproduces.figure;
  entry.table = diagram.reproduces.table;
  entry.section = diagram.reproduces.section;
  entry.title = diagram.title;
  entry.caption = diagram.caption;
  entry.source_caption = diagram.reproduces.caption;
  entry.source_says = diagram.reproduces.says;
  entry.departures = diagram.reproduces.departures;
  for (const diagram::DiagramParameter& parameter : diagram.parameters)
    if (parameter.assumed) add_assumption(parameter, entry.assumptions);
}

gallery::GallerySource source_of(const std::string& file, const std::string& root) {
  const fs::path inside = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(root));
  const bool outside = inside.empty() || *inside.begin() == "..";
  const fs::path place = outside ? "elsewhere" / fs::path(file).filename() : inside;
  return {"diagrams/" + place.generic_string(), io::read_file(file)};
}

/// Returns copies of the diagram file and of its parts, at their paths relative to `root`. They can be run
/// from the gallery.
std::vector<gallery::GallerySource> sources_of(const session::LoadedModel& model, const std::string& root) {
  std::vector<gallery::GallerySource> sources;
  std::vector<std::string> seen;
  for (const diagram::ScopeInfo& scope : model.job.plan.diagram.scopes) {
    if (std::ranges::find(seen, scope.file) != seen.end()) continue;
    seen.push_back(scope.file);
    sources.push_back(source_of(scope.file, root));
  }
  return sources;
}

/// Adds the pictures that a run wrote into its folder under `out`, with sizes and captions. Also writes a
/// script that contains their texts. Throws EnvironmentError.
void add_pictures(const session::LoadedModel& model, const std::vector<std::string>& files,
                  const std::string& out, gallery::GalleryEntry& entry) {
  std::map<std::string, std::string> texts;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const bool of_figure = i < model.figures.size() && files[i] == io::numbered("figure", i, ".svg");
    gallery::GalleryPicture picture = of_figure ? picture_of(model.figures[i]) : extra_picture(files[i]);
    picture.file = files[i];
    texts[files[i]] = io::read_file(fmt::format("{}/{}/{}", out, entry.folder, files[i]));
    gallery::read_picture(picture, texts[files[i]]);
    picture.alt = fmt::format("{}, picture {} of {}: {}", entry.label.empty() ? entry.title : entry.label,
                              i + 1, files.size(), picture.alt);
    entry.pictures.push_back(std::move(picture));
  }
  io::write_file(fmt::format("{}/{}/pictures.js", out, entry.folder), gallery::picture_script(texts));
}

/// Adds every file in the folder of an entry as a download.
void add_downloads(const std::string& out, gallery::GalleryEntry& entry) {
  std::error_code error;
  for (const auto& file : fs::directory_iterator(fs::path(out) / entry.folder, error))
    if (file.is_regular_file(error))
      entry.downloads.push_back({file.path().filename().string(), file.file_size(error)});
  std::ranges::sort(entry.downloads, {}, [](const gallery::GalleryDownload& file) {
    const fs::path path = file.file;
    return std::pair(path.stem(), path.extension());
  });
}

constexpr const char* printer = "rsvg-convert";

/// Converts SVG pages to one PDF, or loads it from the cache.
std::string printed(const std::string& program, const std::vector<std::string>& pages) {
  hash::Hash hash;
  hash.add(printer);
  for (const std::string& page : pages) hash.add(page);
  const io::Cache cache;
  const std::string name = hash.text() + ".pdf";
  if (std::optional<std::string> text = cache.find(name)) return *std::move(text);
  const subprocess::ScratchFolder folder;
  // Fixes the creation time in the PDF, so that equal pages give equal bytes.
  subprocess::ProcessCall call{.command = {"env", "SOURCE_DATE_EPOCH=0", program, "--format=pdf"}};
  for (std::size_t i = 0; i < pages.size(); ++i) {
    call.command.push_back(folder.path() + "/" + io::numbered("page", i, ".svg"));
    io::write_file(call.command.back(), pages[i]);
  }
  const subprocess::ProcessResult answer = subprocess::run_helper(printer, call);
  cache.keep(name, answer.output);
  return answer.output;
}

/// The entries of one chapter, and the pages of their pictures.
struct Chapter {
  std::string file;
  std::vector<gallery::GalleryEntry*> entries;
  std::vector<std::string> pages;  ///< SVG pages
  std::vector<render::Bookmark> bookmarks;

  void add(const std::string& out, gallery::GalleryEntry& entry) {
    entry.print = {file, pages.size() + 1};
    entries.push_back(&entry);
    bookmarks.push_back({gallery::printed_name(entry), entry.print.page});
    for (const gallery::GalleryPicture& picture : entry.pictures)
      pages.push_back(gallery::printed_page(
          entry, picture, io::read_file(fmt::format("{}/{}/{}", out, entry.folder, picture.file))));
  }

  void leave_out(const std::string& note) {
    for (gallery::GalleryEntry* entry : entries) {
      entry->print = {};
      entry->note = note;
    }
  }

  void print(const std::string& program, const std::string& out) {
    if (program.empty())
      return leave_out(fmt::format(
          "There is no PDF, since {} is not installed; on Debian it is the package librsvg2-bin.", printer));
    try {
      io::write_file(out + "/" + file, render::with_outline(printed(program, pages), bookmarks));
    } catch (const std::exception& error) {  // also after an interruption of the printer
      leave_out(fmt::format("There is no PDF: {}", error.what()));
    }
  }
};

/// Returns the file name of a chapter. The chapter is free text in the diagram file, so other names than
/// letters and digits share one file.
std::string print_name(const std::string& chapter) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0; };
  if (chapter.empty() || !std::ranges::all_of(chapter, plain)) return "pictures.pdf";
  return "chapter-" + chapter + ".pdf";
}

/// Writes all pictures of each chapter as one PDF if rsvg-convert is installed. A page has one picture with
/// number and caption of its figure; each figure has a bookmark.
/// Entries of a chapter must be adjacent. Entries without a PDF get a note with the reason. One call of
/// rsvg-convert makes a chapter, because its start takes longer than a picture.
void print_chapters(const std::string& out, std::vector<gallery::GalleryEntry>& entries) {
  std::map<std::string, Chapter> chapters;
  for (gallery::GalleryEntry& entry : entries) {
    if (entry.pictures.empty()) continue;
    const std::string name = print_name(gallery::chapter_of(entry));
    Chapter& chapter = chapters[name];
    chapter.file = name;
    chapter.add(out, entry);
  }
  const std::string program = subprocess::find_program(printer);
  std::vector<Chapter*> all;
  for (auto& [name, chapter] : chapters) all.push_back(&chapter);
  parallel::in_parallel(all.size(), 0, [&](std::size_t i) { all[i]->print(program, out); });
}

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
