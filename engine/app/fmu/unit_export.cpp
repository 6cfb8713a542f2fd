#include "engine/app/fmu/unit_export.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/app/fmu/description.hpp"
#include "engine/app/fmu/variables.hpp"
#include "engine/base/fmi/package.hpp"
#include "engine/base/hash/hash.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/simulate/codegen/between_ticks.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/headers.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/codegen/program_files.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::fmu {
namespace {

using Files = std::map<std::string, std::string>;

constexpr const char* map_file = "fmi-unit.map";  ///< linker script with the exported symbols

const char* kind_word(Kind kind) {
  static constexpr const char* words[] = {"time",  "parameter", "input",    "output",
                                          "state", "slope",     "indicator"};
  return words[static_cast<int>(kind)];
}

/// Format of the compiled source. Arguments: FMI version, include of the diagram's source, its namespace,
/// step, layout, variable count, table rows, token, and the reason for missing model exchange.
constexpr char source_form[] =
    "#include \"engine/app/fmu/diagram_unit.hpp\"\n#include \"engine/app/fmu/functions_of_{0}.hpp\"\n\n"
    "#include {1}\n#undef stepwire\n\nnamespace stepwire::fmu {{\n\nnamespace {{\n\n"
    "struct ThisUnit {{\n  using Diagram = ::{2}::Diagram;\n  static constexpr double step = {3};  // [s]\n"
    "  static constexpr std::uint64_t layout = {4};\n  static constexpr std::uint32_t count = {5};\n"
    "  static const UnitVariable variables[];\n}};\n\n"
    "const UnitVariable ThisUnit::variables[] = {{\n{6}}};\n\n}}  // namespace\n\n"
    "const UnitSource unit_source{{\n    {7}, {8},\n"
    "    [](bool exchange, void* caller, ExportedUnit::Log log) -> ExportedUnit* {{\n"
    "      return new (std::nothrow) DiagramUnit<ThisUnit>(exchange, caller, log);\n    }}}};\n\n"
    "}}  // namespace stepwire::fmu\n";

/// Returns the key of saved states, 16 digits of the token, by which a unit recognizes its own.
std::string layout_text(std::string token) {
  std::erase(token, '-');
  return "0x" + token.substr(1, 16) + "u";
}

std::string row(const Variable& variable) {
  const std::string place =
      variable.place.empty()
          ? "nullptr"
          : fmt::format(
                "[](void* unit) -> double* {{\n       auto& d = *static_cast<ThisUnit::Diagram*>(unit);\n"
                "       return {};\n     }}",
                variable.place);
  return fmt::format("    {{Kind::{}, {}, {}, {}, {}}},\n", kind_word(variable.kind), variable.count(),
                     variable.rows, place, codegen::cpp_string(variable.name));
}

std::string source_text(const plan::Plan& plan, const UnitAbout& about,
                        const std::vector<Variable>& variables, const std::string& no_exchange) {
  const codegen::ProgramNames names(about.identifier);
  std::string rows;
  for (const Variable& variable : variables) rows += row(variable);
  const std::string made =
      codegen::cpp_comment(fmt::format("{} made this from {}", about.made_by, plan.diagram.file));
  return "// " + made + "\n\n" +
         fmt::format(source_form, about.version, codegen::cpp_string(names.source), names.space,
                     codegen::number_text(plan.diagram.step), layout_text(about.token), variables.size(),
                     rows, codegen::cpp_string(about.token),
                     no_exchange.empty() ? "nullptr" : codegen::cpp_string(no_exchange));
}

std::string build_description(const UnitAbout& about, const std::vector<std::string>& folders) {
  Element root{"fmiBuildDescription"};
  root.set("fmiVersion", "3.0");
  Element& configuration = root.add({"BuildConfiguration"}).set("modelIdentifier", about.identifier);
  Element& set = configuration.add({"SourceFileSet"}).set("language", "C++20");
  set.set("compilerOptions", fmt::format("{}", fmt::join(codegen::Compiler::flags(), " ")));
  set.add({"SourceFile"}).set("name", about.source);
  set.add({"IncludeDirectory"}).set("name", ".");
  for (const std::string& folder : folders) set.add({"IncludeDirectory"}).set("name", folder);
  return xml_text(root);
}

/// Format of CMakeLists.txt. Arguments: identifier, source, folders, flags, linker script, search for SLEEF.
constexpr char cmake_form[] =
    "# Builds the binary of this unit for another platform: cmake -S sources -B build && cmake --build "
    "build\n"
    "cmake_minimum_required(VERSION 3.21)\nproject({0} LANGUAGES CXX)\n"
    "add_library({0} MODULE {1})\nset_target_properties({0} PROPERTIES PREFIX \"\")\n"
    "target_include_directories({0} PRIVATE ${{CMAKE_CURRENT_SOURCE_DIR}}{2})\n"
    "find_package(Eigen3 QUIET NO_MODULE)  # which some solvers and blocks need\n"
    "if(TARGET Eigen3::Eigen)\n  target_link_libraries({0} PRIVATE Eigen3::Eigen)\nendif()\n"
    "target_compile_options({0} PRIVATE {3})\n"
    "if(UNIX AND NOT APPLE)\n  target_link_options({0} PRIVATE "
    "-Wl,--version-script=${{CMAKE_CURRENT_SOURCE_DIR}}/{4})\nendif()\n{5}";

std::string cmake_text(const UnitAbout& about, const std::vector<std::string>& folders, bool uses_libm) {
  std::string more;
  for (const std::string& folder : folders) more += " \"${CMAKE_CURRENT_SOURCE_DIR}/" + folder + "\"";
  return fmt::format(cmake_form, about.identifier, about.source, more,
                     fmt::join(codegen::Compiler::flags(), " "), map_file,
                     uses_libm ? "" : codegen::sleef_search(about.identifier));
}

/// Returns the path of a header in the unit. Headers of the engine keep the path of their #include.
std::string place_in_unit(const std::string& path) {
  const std::string own = "stepwire/";
  const bool moves = path.starts_with(own + "engine/") || path.starts_with(own + "blocks/");
  return moves ? path.substr(own.size()) : path;
}

void add_headers(Files& files, int version) {
  const std::string functions = fmt::format("engine/app/fmu/functions_of_{}.hpp", version);
  for (const std::string& header : codegen::with_included({"engine/app/fmu/diagram_unit.hpp", functions}).all)
    files[header] = codegen::header_text(header);
}

/// Returns the source files of a unit by their paths in its folder `sources`. One of them, which contains the
/// token of `about`, is compiled and includes the others. Throws Error for blocks that cannot be generated.
Files unit_sources(const plan::Plan& plan, const codegen::Tuning& tuning, const UnitAbout& about,
                   const std::vector<Variable>& variables, const std::string& no_exchange) {
  const codegen::ProgramNames names(about.identifier);
  const codegen::ProgramOptions options{
      .name = about.identifier, .made_by = about.made_by, .between_ticks = about.exchange};
  Files files;
  for (auto& [path, text] : codegen::program_files(plan, tuning, options))
    if (path != names.main) files[place_in_unit(path)] = text;
  add_headers(files, about.version);
  const std::vector<std::string> folders = codegen::header_folders(plan);
  files["CMakeLists.txt"] = cmake_text(about, folders, plan.diagram.uses_libm);
  if (about.version == 3) files["buildDescription.xml"] = build_description(about, folders);
  files[map_file] = fmt::format("{{ global: fmi{}*; local: *; }};\n", about.version);
  files[about.source] = source_text(plan, about, variables, no_exchange);
  return files;
}

/// Returns the additional compiler flags of a binary that exports only the FMI functions. `folder` has the
/// sources, `header_folders` the headers of third parties in it.
std::vector<std::string> unit_flags(const std::string& folder,
                                    const std::vector<std::string>& header_folders) {
  std::vector<std::string> flags{"-I", folder, "-Wl,--version-script=" + folder + "/" + map_file,
                                 "-DSTEPWIRE_SLEEF", "-Wl,-rpath,$ORIGIN"};
  for (const std::string& of_others : header_folders)
    flags.insert(flags.end(), {"-I", folder + "/" + of_others});
  return flags;
}

/// Returns the index of the k-th number in row-major order: "[2]", "[1,3]".
std::string subscript(const Variable& variable, std::size_t k) {
  if (variable.sizes.size() == 1) return fmt::format("[{}]", k + 1);
  const auto columns = static_cast<std::size_t>(variable.sizes[1]);
  return fmt::format("[{},{}]", k / columns + 1, k % columns + 1);
}

/// Returns the offset of the k-th number in memory, which is column-major.
std::size_t place_behind(const Variable& variable, std::size_t k) {
  if (variable.rows == 1) return k;
  const std::size_t columns = variable.count() / static_cast<std::size_t>(variable.rows);
  return k % columns * static_cast<std::size_t>(variable.rows) + k / columns;
}

Variable scalar_of(const Variable& variable, std::size_t k) {
  Variable scalar = variable;
  scalar.sizes.clear();
  scalar.rows = 1;
  const std::string index = subscript(variable, k);
  const bool slope = variable.kind == Kind::slope && variable.name.ends_with(')');
  scalar.name =
      slope ? variable.name.substr(0, variable.name.size() - 1) + index + ")" : variable.name + index;
  scalar.place = fmt::format("{} + {}", variable.place, place_behind(variable, k));
  if (!variable.start.empty()) scalar.start = {variable.start[k]};
  return scalar;
}

/// Splits array variables into scalars, because FMI 2 has no arrays: "x[2]", "m[1,3]", "der(x[2])". Event
/// indicators are dropped, since they are no variables in FMI 2.
std::vector<Variable> scalars_of(const std::vector<Variable>& variables) {
  std::vector<Variable> scalars;
  std::vector<int> first;  // index of the first scalar of each variable
  for (const Variable& variable : variables) {
    first.push_back(static_cast<int>(scalars.size()));
    if (variable.kind == Kind::indicator) continue;
    for (std::size_t k = 0; k < variable.count(); ++k) {
      scalars.push_back(variable.sizes.empty() ? variable : scalar_of(variable, k));
      if (variable.derivative_of >= 0)
        scalars.back().derivative_of =
            first[static_cast<std::size_t>(variable.derivative_of)] + static_cast<int>(k);
    }
  }
  return scalars;
}

using svg::markup_escaped;

std::string numbers_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : " ") + xml_number(number);
  return text;
}

std::string rows_of(const std::vector<Variable>& variables, const std::string& causality) {
  std::string rows;
  for (const Variable& variable : variables)
    if (variable.causality == causality)
      rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                          markup_escaped(variable.name), markup_escaped(unit_name(variable)),
                          numbers_text(variable.start), markup_escaped(variable.about));
  return rows;
}

std::string table(const std::vector<Variable>& variables, const std::string& causality,
                  const std::string& title) {
  const std::string rows = rows_of(variables, causality);
  if (rows.empty()) return "";
  return fmt::format(
      "<h2>{}</h2>\n<table>\n<tr><th>name</th><th>unit</th><th>start</th><th></th></tr>\n{}</table>\n", title,
      rows);
}

std::string exchange_text(const UnitAbout& about, const std::string& no_exchange) {
  return about.exchange
             ? "<p>By model exchange a solver of the importer integrates its states.</p>\n"
             : fmt::format("<p>There is no model exchange: {}.</p>\n", markup_escaped(no_exchange));
}

std::string fixed_text(const std::vector<codegen::FixedParameter>& fixed) {
  if (fixed.empty()) return "";
  std::string items;
  for (const codegen::FixedParameter& one : fixed)
    items += fmt::format("<li>{}: {}</li>\n", markup_escaped(one.name), markup_escaped(one.reason));
  return "<h2>Parameters that keep their value</h2>\n<ul>\n" + items + "</ul>\n";
}

/// Returns the HTML page of a unit: its description, its variables, and the conditions for bitwise equal
/// results. Parameters in `fixed` cannot be set, for the given reasons. The flag `drawn` is true if
/// diagram.svg exists beside the page.
std::string unit_page(const UnitAbout& about, const std::vector<Variable>& variables,
                      const std::vector<codegen::FixedParameter>& fixed, const std::string& no_exchange,
                      bool drawn) {
  const std::string title = markup_escaped(about.title.empty() ? about.name : about.title);
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>{0}</title></head>\n"
             "<body>\n<h1>{0}</h1>\n{1}<p>A unit of FMI {2}, made by {3}. All numbers are SI.</p>\n"
             "<p>By co-simulation it makes whole numbers of steps of {4} s, with the bits of the diagram's "
             "own run; "
             "outputs follow from the inputs that were set last.</p>\n",
             title, drawn ? "<p><img src=\"diagram.svg\" alt=\"the diagram\"></p>\n" : "", about.version,
             markup_escaped(about.made_by), xml_number(about.step)) +
         exchange_text(about, no_exchange) +
         "<p>Directional derivatives are differences to both sides, not exact.</p>\n" +
         table(variables, "parameter", "Parameters") + table(variables, "input", "Inputs") +
         table(variables, "output", "Outputs") + fixed_text(fixed) + "</body>\n</html>\n";
}

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

/// Adds the library of elementary functions beside a binary that needs it, so that no host must have it.
void add_elementary_functions(Files& files, const std::string& folder, const std::string& binary) {
  const std::string needed = codegen::Compiler::elementary_functions;
  if (files.at(binary).find(needed) == std::string::npos) return;
  Dl_info info{};
  const void* function = ::dlsym(RTLD_DEFAULT, "Sleef_cinz_sind1_u10purec");
  if (!function || ::dladdr(function, &info) == 0) throw io::EnvironmentError(needed + " cannot be found");
  files[folder + needed] = io::read_file(info.dli_fname);
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
  const std::string folder = fmi::binary_folder(options.version), binary = folder + about.identifier + ".so";
  made.files[binary] = compiled(sources, plan, about, options, compiler);
  add_elementary_functions(made.files, folder, binary);
  for (const auto& [path, text] : sources) made.files["sources/" + path] = text;
  made.files["documentation/index.html"] =
      unit_page(about, variables, tuning.fixed, made.no_exchange, !options.drawing.empty());
  add_pictures(made.files, options);
  return made;
}

}  // namespace stepwire::fmu
