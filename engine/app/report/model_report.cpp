#include "engine/app/report/model_report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "engine/analyse/coverage/coverage.hpp"
#include "engine/app/report/coverage_picture.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/model/diagram/bindings.hpp"
#include "engine/model/diagram/part_alone.hpp"
#include "engine/model/diagram/uses.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/gallery/gallery_picture.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::report {

namespace {

namespace fs = std::filesystem;

/// Returns the limits of a parameter as written: "above 0 kg, at_most 5 kg".
std::string limits_text(const diagram::Definition& definition) {
  std::vector<std::string> limits;
  for (const yaml::Entry& bound : definition.bounds) limits.push_back(bound.key + " " + bound.value.text);
  return fmt::format("{}", fmt::join(limits, ", "));
}

gallery::ReportTable parameters_table(const diagram::Diagram& diagram) {
  gallery::ReportTable table{"Parameters", {"Name", "Value", "Unit (SI)", "Limits", "Meaning"}, {}};
  for (std::size_t i = 0; i < diagram.parameters.size(); ++i) {
    const diagram::DiagramParameter& one = diagram.parameters[i];
    const bool known = diagram.bindings && i < diagram.bindings->definitions.size();
    table.rows.push_back({one.name, one.text, one.dimension ? unit::si_name(*one.dimension) : "",
                          known ? limits_text(diagram.bindings->definitions[i]) : "",
                          one.doc + (one.assumed ? (one.doc.empty() ? "assumed" : " (assumed)") : "")});
  }
  return table;
}

gallery::ReportTable records_table(const plan::Plan& plan) {
  gallery::ReportTable table{"Records", {"Signal", "Unit (SI)", "Every"}, {}};
  for (const diagram::RecordRequest& record : plan.diagram.records)
    for (const diagram::RecordedSignal& signal : record.signals) {
      const auto dimension = plan.dimension(signal.signal);
      table.rows.push_back({signal.name, dimension ? unit::si_name(*dimension) : "not known",
                            record.instants ? "each instant"
                            : record.every  ? fmt::format("{:g} s", *record.every)
                                            : fmt::format("{:g} s", plan.diagram.step)});
    }
  return table;
}

/// Returns sources that the declarations of the used blocks name.
gallery::ReportTable sources_table(const diagram::Diagram& diagram) {
  gallery::ReportTable table{"Blocks", {"Type", "Number", "Meaning", "Source"}, {}};
  std::map<const BlockType*, std::size_t> types;
  for (const diagram::DiagramBlock& block : diagram.blocks) ++types[&block.type()];
  for (const auto& [type, count] : types)
    table.rows.push_back({type->name, std::to_string(count), type->doc, type->source});
  std::ranges::sort(table.rows);
  return table;
}

gallery::ReportTable coverage_table(const coverage::Coverage& coverage) {
  gallery::ReportTable table{"Coverage", {"Block", "Type", "Condition", "Never"}, {}};
  table.note = coverage.branches() == 0
                   ? "No block has a condition."
                   : fmt::format("The runs took {} of {} branches.", coverage.covered(), coverage.branches());
  for (const coverage::Condition& condition : coverage.conditions)
    for (const coverage::Branch& branch : condition.branches)
      if (branch.ticks == 0)
        table.rows.push_back({condition.block, condition.type, condition.what, branch.name});
  return table;
}

gallery::ReportTable version_table(const session::LoadedModel& model) {
  gallery::ReportTable table{"Versions", {"What", "Value"}, {}};
  table.rows = {{"file", model.file},
                {"hash of the flattened diagram", model.hash},
                {"step", fmt::format("{:g} s", model.job.plan.diagram.step)},
                {"ticks", std::to_string(model.job.plan.steps)},
                {"solver", model.job.plan.diagram.solver},
                {"stepwire", session::program_version()},
                {"compiler", session::compiler_version()}};
  for (const diagram::Use& use : diagram::used_repositories(model.job.plan.diagram))
    table.rows.push_back({"parts of " + use.name, fmt::format("{} at {}", use.git, use.rev)});
  return table;
}

/// Adds the drawing of a file, and one with all parts opened.
void add_drawings(const Registry& registry, const session::LoadedModel& model,
                  const coverage::Coverage& coverage, gallery::Report& report) {
  try {
    diagram::Loader loader(registry);
    const drawing::DrawnFile file(loader, model.file);
    drawing::GraphOptions options;
    options.units = true;
    report.drawings.push_back(
        {"Blocks and wires", "", "the block diagram", drawing::draw_picture(file.view().graph(options))});
    options.names = names_with_coverage(coverage);
    if (file.view().parts().empty() && options.names.empty()) return;
    options.depth = 32;
    report.drawings.push_back(
        {"All parts opened",
         options.names.empty() ? "" : "Blocks with branches that no run takes have their numbers.",
         "the block diagram with all parts opened", drawing::draw_picture(file.view().graph(options))});
  } catch (const io::EnvironmentError& error) {
    report.tables.push_back({"Drawing", {}, {}, std::string("There is no drawing: ") + error.what()});
  }
}

void add_figures(const session::LoadedModel& model, const session::Outcome& outcome,
                 gallery::Report& report) {
  try {
    for (const plot::Figure& figure : model.figures)
      report.figures.push_back({figure.title, figure.caption, gallery::described(figure),
                                render::draw(figure, outcome.recordings()).svg});
  } catch (const io::EnvironmentError& error) {
    report.tables.push_back({"Figures", {}, {}, std::string("There are no figures: ") + error.what()});
  }
}

void add_sources(const session::LoadedModel& model, gallery::GalleryEntry& entry) {
  for (const diagram::ScopeInfo& scope : model.job.plan.diagram.scopes) {
    const auto is_same = [&](const gallery::GallerySource& one) { return one.path == scope.file; };
    if (std::ranges::none_of(entry.sources, is_same))
      entry.sources.push_back({scope.file, io::read_file(scope.file)});
  }
}

void fill_report(const Registry& registry, const session::LoadOptions& options,
                 const session::Monitor& monitor, gallery::Report& report) {
  coverage::CoverageObserver observer;
  session::Session session(registry, {monitor.interrupt, {}, {}, {&observer}});
  session::LoadedModel model = session.load(report.entry.folder, options);
  if (model.fit) model = session.fitted(model, session.fit(model));
  const diagram::Diagram& diagram = model.job.plan.diagram;
  if (!diagram.title.empty()) report.entry.title = diagram.title;
  report.entry.caption = diagram.caption;
  add_sources(model, report.entry);
  const session::Outcome outcome =
      model.study ? session::study_outcome(model, *session.study(model)) : session.run(model);
  report.entry.verdicts = outcome.verdicts;
  if (!outcome.result.faults.empty()) report.entry.error = outcome.result.faults.front().fault.text();
  add_drawings(registry, model, observer.coverage(), report);
  if (!outcome.early()) add_figures(model, outcome, report);
  report.tables.push_back(parameters_table(diagram));
  report.tables.push_back(records_table(model.job.plan));
  if (!model.study) report.tables.push_back(coverage_table(observer.coverage()));
  report.tables.push_back(sources_table(diagram));
  report.tables.push_back(version_table(model));
}

}  // namespace

gallery::Report model_report(const Registry& registry, const std::string& file,
                             const session::LoadOptions& options, const session::Monitor& monitor) {
  gallery::Report report;
  report.entry.folder = file;
  report.entry.title = fs::path(file).stem().string();
  try {
    fill_report(registry, options, monitor, report);
  } catch (const yaml::Error& error) {
    report.entry.error = error.what();
  }
  return report;
}

/// True for a file that is used in others and has no run of its own, and for one that is no diagram. A file
/// that cannot be read is none, so that its fault is shown.
static bool has_no_run(const std::string& file) {
  try {
    const yaml::Document document = yaml::read_document(file);
    if (diagram::is_other_map(document.root)) return true;
    return !document.root.find("step") && (document.root.find("inputs") || document.root.find("outputs"));
  } catch (const yaml::Error&) {
    return false;
  }
}

std::vector<std::string> diagram_files(const std::string& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".yaml" && !has_no_run(entry.path().string()))
      files.push_back(entry.path().string());
  if (files.empty()) throw yaml::Error(yaml::Fault{{path, {}}, "", "has no diagram file, NAME.yaml", {}});
  std::ranges::sort(files);
  return files;
}

void print_page(const std::string& html, const std::string& pdf) {
  std::string program;
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
    if (program.empty()) program = subprocess::find_program(name);
  if (program.empty())
    throw io::EnvironmentError(
        "chromium is not installed, which prints the page; on Debian it is the package chromium");
  const subprocess::ScratchFolder folder;
  const std::string page = folder.path() + "/report.html";
  io::write_file(page, html);
  subprocess::ProcessCall call{.command = {program, "--headless", "--disable-gpu", "--no-pdf-header-footer"}};
  if (::geteuid() == 0) call.command.emplace_back("--no-sandbox");  // its sandbox needs another user
  call.command.push_back("--user-data-dir=" + folder.path() + "/profile");
  call.command.push_back("--print-to-pdf=" + folder.path() + "/report.pdf");
  call.command.push_back("file://" + page);
  subprocess::run_helper("chromium", call);
  io::write_file(pdf, io::read_file(folder.path() + "/report.pdf"));
}

}  // namespace stepwire::report
