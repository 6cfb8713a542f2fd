#include "engine/app/fmu/unit_sources.hpp"

#include <fmt/format.h>

#include "engine/app/fmu/element.hpp"
#include "engine/simulate/codegen/between_ticks.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/cpp_words.hpp"
#include "engine/simulate/codegen/headers.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/program_files.hpp"

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

/// Format of CMakeLists.txt. Arguments: identifier, source, folders, flags, linker script.
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
    "-Wl,--version-script=${{CMAKE_CURRENT_SOURCE_DIR}}/{4})\nendif()\n";

std::string cmake_text(const UnitAbout& about, const std::vector<std::string>& folders) {
  std::string more;
  for (const std::string& folder : folders) more += " \"${CMAKE_CURRENT_SOURCE_DIR}/" + folder + "\"";
  return fmt::format(cmake_form, about.identifier, about.source, more,
                     fmt::join(codegen::Compiler::flags(), " "), map_file);
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

}  // namespace

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
  files["CMakeLists.txt"] = cmake_text(about, folders);
  if (about.version == 3) files["buildDescription.xml"] = build_description(about, folders);
  files[map_file] = fmt::format("{{ global: fmi{}*; local: *; }};\n", about.version);
  files[about.source] = source_text(plan, about, variables, no_exchange);
  return files;
}

std::vector<std::string> unit_flags(const std::string& folder,
                                    const std::vector<std::string>& header_folders) {
  std::vector<std::string> flags{"-I", folder, "-Wl,--version-script=" + folder + "/" + map_file};
  for (const std::string& of_others : header_folders)
    flags.insert(flags.end(), {"-I", folder + "/" + of_others});
  return flags;
}

}  // namespace stepwire::fmu
