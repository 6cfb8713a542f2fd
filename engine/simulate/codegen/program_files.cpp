#include "engine/simulate/codegen/program_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "engine/simulate/codegen/c_interface.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/cpp_words.hpp"
#include "engine/simulate/codegen/diagram_struct.hpp"
#include "engine/simulate/codegen/headers.hpp"
#include "engine/simulate/codegen/program.hpp"
#include "engine/simulate/codegen/program_main.hpp"
#include "engine/simulate/codegen/value_text.hpp"

namespace stepwire::codegen {

namespace {

namespace fs = std::filesystem;

/// Check for builds without CMake.
constexpr char eigen_check[] =
    "#if !__has_include(<Eigen/Core>)\n"
    "#error this diagram needs the headers of Eigen 3: -I names their folder, /usr/include/eigen3 with "
    "Debian\n"
    "#error package libeigen3-dev\n"
    "#endif\n\n";
constexpr char eigen_search[] =
    "# Solver or blocks need the headers of Eigen.\n"
    "find_package(Eigen3 QUIET NO_MODULE)\n"
    "if(NOT TARGET Eigen3::Eigen)\n"
    "  message(FATAL_ERROR \"{0} needs the headers of Eigen 3; on Debian the package libeigen3-dev has them, "
    "else \"\n"
    "                      \"-DEigen3_DIR=FOLDER names the folder of their Eigen3Config.cmake\")\n"
    "endif()\n\n";

/// Layout of headers in a program's folder: those of stepwire are under stepwire/, foreign ones under
/// blocks_of_others/ in their relative positions.
class HeaderFiles {
 public:
  explicit HeaderFiles(const IncludedHeaders& headers) : headers_(headers) {
    for (const std::string& header : headers.all)
      if (is_of_others(header)) widen(fs::path(header).parent_path());
    for (const std::string& folder : headers.folders) widen(folder);
  }

  /// Returns the path of a header as sources include it.
  std::string included(const std::string& header) const {
    return is_of_others(header) ? moved(header) : header;
  }
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> files;
    for (const std::string& header : headers_.all) {
      const bool has_place = is_of_others(header) || header.starts_with("stepwire/");
      files[has_place ? included(header) : "stepwire/" + header] = header_text(header);
    }
    return files;
  }
  /// Returns the include folders beside that of the program and stepwire/.
  std::vector<std::string> folders() const {
    std::vector<std::string> folders;
    for (const std::string& folder : headers_.folders) folders.push_back(moved(folder));
    return folders;
  }

 private:
  void widen(const fs::path& folder) {
    if (common_.empty()) common_ = folder;
    while (common_ != common_.root_path() &&
           fs::path(folder).lexically_relative(common_).string().starts_with(".."))
      common_ = common_.parent_path();
  }
  std::string moved(const std::string& path) const {
    return (fs::path("blocks_of_others") / fs::path(path).lexically_relative(common_))
        .lexically_normal()
        .string();
  }

  const IncludedHeaders& headers_;
  fs::path common_;  ///< common parent folder of all foreign headers
};

/// Placeholders: name, sources, flags, main program, then found packages, linked libraries, compile options
/// and include folders.
constexpr char cmake_form[] =
    "cmake_minimum_required(VERSION 3.21)\n"
    "project({0} LANGUAGES CXX)\n\n"
    "if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE)\n  set(CMAKE_BUILD_TYPE Release)\nendif()\n"
    "set(CMAKE_CXX_FLAGS_RELEASE \"\")  # the flags below are all there is to it\n\n"
    "{4}# The diagram, for add_subdirectory() and target_link_libraries(... {0}::{0}).\n"
    "add_library({0} STATIC {1}.cpp{6})\n"
    "add_library({0}::{0} ALIAS {0})\n"
    "target_include_directories({0} PUBLIC ${{CMAKE_CURRENT_SOURCE_DIR}} PRIVATE "
    "${{CMAKE_CURRENT_SOURCE_DIR}}/stepwire{7})\n"
    "set_target_properties({0} PROPERTIES POSITION_INDEPENDENT_CODE ON)\n"
    "# What keeps the bits of `stepwire run`: -ffp-contract=off (no fused multiply-add) and "
    "-fno-builtin-... (functions\n"
    "# of the library, none computed by the compiler). Another -O or -march may be taken, never "
    "-ffast-math.\n"
    "target_compile_options({0} PRIVATE{2})\n"
    "if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)  # passes that find little in straight-line code\n"
    "  target_compile_options({0} PRIVATE -fno-tree-pta -fno-tree-slp-vectorize)\n"
    "endif()\n{5}\n"
    "# The program that writes what the diagram records; in another project built on demand only.\n"
    "add_executable({0}_main {3})\n"
    "target_link_libraries({0}_main PRIVATE {0})\n"
    "target_compile_features({0}_main PRIVATE cxx_std_20)\n"
    "set_target_properties({0}_main PROPERTIES OUTPUT_NAME {0} RUNTIME_OUTPUT_DIRECTORY "
    "${{CMAKE_CURRENT_BINARY_DIR}}/bin)\n"
    "if(NOT PROJECT_IS_TOP_LEVEL)\n"
    "  set_target_properties({0}_main PROPERTIES EXCLUDE_FROM_ALL TRUE)\n"
    "endif()\n";

std::string cmake_text(const ProgramNames& names, const std::vector<std::string>& folders, bool c_interface,
                       bool uses_eigen) {
  std::string more;
  for (const std::string& folder : folders)
    more += fmt::format(" \"${{CMAKE_CURRENT_SOURCE_DIR}}/{}\"", folder);
  std::string flags;
  for (const std::string& flag : Compiler::flags()) flags += " " + flag;
  return fmt::format(
      cmake_form, names.space, names.stem, flags, names.main,
      uses_eigen ? fmt::format(eigen_search, names.space) : "",
      uses_eigen ? fmt::format("target_link_libraries({} PRIVATE Eigen3::Eigen)\n", names.space) : "",
      c_interface ? " " + names.c_source : "", more);
}

/// Returns the size of the longest list that a block receives again as parameters change. Lists up to this
/// size are stored without dynamic memory. Returns std::nullopt for foreign blocks, which may make lists of
/// any size.
std::optional<std::size_t> longest_list(const plan::Plan& plan, const Tuning& tuning,
                                        const IncludedHeaders& headers) {
  if (std::ranges::any_of(headers.all, is_of_others)) return std::nullopt;
  auto longest = static_cast<std::size_t>(Numbers::capacity);
  for (const int binding : tuning.bindings) {
    const diagram::Target& target = plan.diagram.bindings->bindings[static_cast<std::size_t>(binding)].target;
    if (target.kind != diagram::Target::Kind::parameter) continue;
    const diagram::DiagramBlock& block = plan.diagram.blocks[static_cast<std::size_t>(target.block)];
    const ParameterSpec& spec = block.type().parameters[static_cast<std::size_t>(target.index)];
    longest = std::max(longest, numbers_of(spec.get(block.block.get())).size());
  }
  return longest;
}

std::string source_text(const GeneratedProgram& program, const ProgramNames& names,
                        const HeaderFiles& headers, const std::optional<std::size_t>& longest,
                        const std::string& definitions) {
  std::string text = fmt::format("#include \"{}\"\n\n", names.header);
  if (longest)
    text += fmt::format(
        "// No list of a block is longer, so that none needs a heap.\n"
        "#define STEPWIRE_LONGEST_LIST {}\n",
        *longest);
  if (needs_eigen(headers.files())) text += eigen_check;
  text += fmt::format(
      "#include <bit>\n#include <cmath>\n#include <cstring>\n#include <limits>\n\n"
      "// Blocks of another version may be linked beside these.\n#define stepwire stepwire_of_{}\n",
      names.space);
  for (const std::string& header : program.headers)
    text += fmt::format("#include \"{}\"\n", headers.included(header));
  return text + "\nnamespace {\n\nusing namespace stepwire;\n\n" + program.text + "\n}  // namespace\n\n" +
         definitions;
}

}  // namespace

bool needs_eigen(const std::map<std::string, std::string>& files) {
  return std::ranges::any_of(
      files, [](const auto& file) { return file.second.find("#include <Eigen/") != std::string::npos; });
}

ProgramNames::ProgramNames(const std::string& name)
    : stem(cpp_identifier(name)),
      space(stem + "_diagram"),
      header(stem + ".hpp"),
      source(stem + ".cpp"),
      main(stem + "-main.cpp"),
      c_header(stem + "-c.h"),
      c_source(stem + "-c.cpp") {}

std::map<std::string, std::string> program_files(const plan::Plan& plan, const Tuning& tuning,
                                                 const ProgramOptions& options) {
  const GeneratedProgram program = make_program(plan, tuning, options.between_ticks);
  const ProgramNames names(options.name);
  const IncludedHeaders included = with_included(program.headers);
  const HeaderFiles headers(included);
  const Groups groups(plan, tuning);
  const std::string made =
      cpp_comment(fmt::format("{} made this from {}", options.made_by, plan.diagram.file));
  const std::string note = "// " + made + "\n\n";
  std::map<std::string, std::string> files;
  files[names.header] = note + struct_text(plan, tuning, groups, names.space, options.between_ticks);
  files[names.source] =
      note + source_text(program, names, headers, longest_list(plan, tuning, included),
                         struct_definitions(plan, tuning, groups, names.space, options.between_ticks));
  files[names.main] = note + main_text(plan, names.header, names.space);
  if (options.c_interface) {
    const CInterface c = c_interface(plan, tuning, groups, names.space, names.header, names.c_header);
    files[names.c_header] = "/* " + made + " */\n\n" + c.header;
    files[names.c_source] = note + c.source;
  }
  files.merge(headers.files());
  files["CMakeLists.txt"] = cmake_text(names, headers.folders(), options.c_interface, needs_eigen(files));
  return files;
}

std::vector<std::string> header_folders(const plan::Plan& plan) {
  const IncludedHeaders included = with_included(headers_of(plan));
  return HeaderFiles(included).folders();
}

}  // namespace stepwire::codegen
