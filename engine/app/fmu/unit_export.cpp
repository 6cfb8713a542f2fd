#include "engine/app/fmu/unit_export.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "engine/app/fmu/element.hpp"
#include "engine/app/fmu/page.hpp"
#include "engine/app/fmu/scalars.hpp"
#include "engine/app/fmu/unit_sources.hpp"
#include "engine/base/fmi/package.hpp"
#include "engine/base/hash/hash.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/simulate/codegen/between_ticks.hpp"
#include "engine/simulate/codegen/cpp_words.hpp"
#include "engine/simulate/codegen/program_files.hpp"

namespace stepwire::fmu {

namespace {

using Files = std::map<std::string, std::string>;

/// Returns the instantiation token, "{2f6c8a10-...}": a hash of the sources and the description.
std::string token_of(const Files& sources, const std::string& description) {
  hash::Hash hash;
  hash.add(description);
  for (const auto& [path, text] : sources) hash.add(path).add(text);
  std::string digits = hash.text();
  for (const std::size_t at : {20, 16, 12, 8}) digits.insert(at, "-");
  return "{" + digits + "}";
}

std::string compiled(const Files& sources, const plan::Plan& plan, const UnitAbout& about,
                     const ExportOptions& options, const codegen::Compiler& compiler) {
  if (!compiler.found()) throw io::EnvironmentError(compiler.problem() + "; a unit has a binary");
  const subprocess::ScratchFolder folder;
  for (const auto& [path, text] : sources) io::write_file(folder.path() + "/" + path, text);
  std::vector<std::string> flags = unit_flags(folder.path(), codegen::header_folders(plan));
  flags.insert(flags.end(), options.flags.begin(), options.flags.end());
  const std::string library = folder.path() + "/unit.so";
  const std::string problem = compiler.compile(folder.path() + "/" + about.source, library, flags, {});
  if (!problem.empty() || !std::filesystem::exists(library))
    throw io::EnvironmentError("the unit's binary cannot be made: " + problem);
  return io::read_file(library);
}

std::string icon_description() {
  Element root{"fmiTerminalsAndIcons"};
  root.set("fmiVersion", "3.0");
  Element& picture = root.add({"GraphicalRepresentation"});
  picture.add({"CoordinateSystem"})
      .set("x1", -100.0)
      .set("y1", -100.0)
      .set("x2", 100.0)
      .set("y2", 100.0)
      .set("suggestedScalingFactorTo_mm", 0.1);
  picture.add({"Icon"}).set("x1", -100.0).set("y1", -100.0).set("x2", 100.0).set("y2", 100.0);
  return xml_text(root);
}

void add_pictures(Files& files, const ExportOptions& options) {
  if (!options.drawing.empty()) files["documentation/diagram.svg"] = options.drawing;
  if (options.icon.empty()) return;
  if (options.version == 2) {
    files["model.png"] = options.icon;
    return;
  }
  files["terminalsAndIcons/icon.png"] = options.icon;
  files["terminalsAndIcons/icon.svg"] = options.drawing;
  files["terminalsAndIcons/terminalsAndIcons.xml"] = icon_description();
}

}  // namespace

UnitExport export_unit(const plan::Plan& plan, const codegen::Tuning& tuning, const ExportOptions& options,
                       const codegen::Compiler& compiler) {
  UnitExport made{{}, codegen::why_ticks_only(plan)};
  UnitAbout about{
      options.version,          options.name,        codegen::cpp_identifier(options.name),
      plan.diagram.title,       options.made_by,     "{0000000000000000}",
      "fmi-unit.cpp",           plan.diagram.step,   static_cast<double>(plan.steps) * plan.diagram.step,
      made.no_exchange.empty(), plan.crossing_count, !plan.jumps};
  std::vector<Variable> variables = variables_of(plan, tuning, about.exchange);
  if (options.version == 2) variables = scalars_of(variables);
  about.token = token_of(unit_sources(plan, tuning, about, variables, made.no_exchange),
                         description_text(about, variables));
  const Files sources = unit_sources(plan, tuning, about, variables, made.no_exchange);
  made.files["modelDescription.xml"] = description_text(about, variables);
  made.files[fmi::binary_folder(options.version) + about.identifier + ".so"] =
      compiled(sources, plan, about, options, compiler);
  for (const auto& [path, text] : sources) made.files["sources/" + path] = text;
  made.files["documentation/index.html"] =
      unit_page(about, variables, tuning.fixed, made.no_exchange, !options.drawing.empty());
  add_pictures(made.files, options);
  return made;
}

}  // namespace stepwire::fmu
