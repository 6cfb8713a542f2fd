#include "engine/app/thesis/thesis_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "engine/app/thesis/thesis_data.hpp"
#include "engine/base/io/file.hpp"
#include "engine/view/gallery/gallery_picture.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::thesis {

namespace {

namespace fs = std::filesystem;

std::string label_of(const diagram::Diagram& diagram) {
  std::string label;
  if (diagram.thesis.figure) label = fmt::format("Figure {}", *diagram.thesis.figure);
  if (diagram.thesis.table)
    label += fmt::format("{}Table {}", label.empty() ? "" : " and ", *diagram.thesis.table);
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

}  // namespace

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

void describe_entry(const session::LoadedModel& model, gallery::GalleryEntry& entry) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  entry.label = label_of(diagram);
  entry.figure = diagram.thesis.figure;
  entry.table = diagram.thesis.table;
  entry.section = diagram.thesis.section;
  entry.title = diagram.title;
  entry.caption = diagram.caption;
  entry.source_caption = diagram.thesis.caption;
  entry.source_says = diagram.thesis.says;
  entry.departures = diagram.thesis.departures;
  for (const diagram::DiagramParameter& parameter : diagram.parameters)
    if (parameter.assumed) add_assumption(parameter, entry.assumptions);
}

gallery::GallerySource source_of(const std::string& file, const std::string& root) {
  const fs::path inside = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(root));
  const bool outside = inside.empty() || *inside.begin() == "..";
  const fs::path place = outside ? "elsewhere" / fs::path(file).filename() : inside;
  return {"diagrams/" + place.generic_string(), io::read_file(file)};
}

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

}  // namespace stepwire::thesis
