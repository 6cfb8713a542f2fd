#include "engine/simulate/codegen/program_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/cpp_words.hpp"
#include "engine/simulate/codegen/diagram_struct.hpp"
#include "engine/simulate/codegen/headers.hpp"
#include "engine/simulate/codegen/program.hpp"
#include "engine/simulate/codegen/program_main.hpp"

namespace stepwire {

namespace {

/// What a program is called in its own files. Each is a word that is none of C++, of a library or of CMake.
struct OwnNames {
  explicit OwnNames(const std::string& of_file)
      : stem(cpp_identifier(of_file)),
        space(stem + "_diagram"),
        header(stem + ".hpp"),
        main(stem + "-main.cpp") {}

  std::string stem;   ///< "rig", of files and of the program
  std::string space;  ///< the namespace
  std::string header;
  std::string main;  ///< no identifier has a '-'
};

bool uses_eigen(const std::map<std::string, std::string>& files) {
  return std::ranges::any_of(
      files, [](const auto& file) { return file.second.find("#include <Eigen/") != std::string::npos; });
}

std::string cmake_text(const OwnNames& names, bool uses_eigen) {
  std::string flags;
  for (const std::string& flag : Compiler::flags()) flags += " " + flag;
  return fmt::format(
      "cmake_minimum_required(VERSION 3.16)\n"
      "project({0} LANGUAGES CXX)\n\n"
      "if(NOT CMAKE_BUILD_TYPE)\n  set(CMAKE_BUILD_TYPE Release)\nendif()\n"
      "set(CMAKE_CXX_FLAGS_RELEASE \"\")  # the flags below are all there is to it\n\n"
      "{4}add_executable({0} {3} {1}.cpp)\n"
      "set_target_properties({0} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "
      "${{CMAKE_CURRENT_BINARY_DIR}}/bin)\n"
      "target_include_directories({0} PRIVATE ${{CMAKE_CURRENT_SOURCE_DIR}} "
      "${{CMAKE_CURRENT_SOURCE_DIR}}/stepwire)\n"
      "# What keeps the bits of `stepwire run`: -ffp-contract=off (no fused multiply-add) and "
      "-fno-builtin-... (functions\n"
      "# of the library, none computed by the compiler). Another -O or -march may be taken, never "
      "-ffast-math.\n"
      "target_compile_options({0} PRIVATE{2})\n"
      "if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)  # passes that find little in straight-line code\n"
      "  target_compile_options({0} PRIVATE -fno-tree-pta -fno-tree-slp-vectorize)\n"
      "endif()\n{5}",
      names.space, names.stem, flags, names.main,
      uses_eigen ? "find_package(Eigen3 REQUIRED NO_MODULE)  # of the solver\n" : "",
      uses_eigen ? fmt::format("target_link_libraries({} PRIVATE Eigen3::Eigen)\n", names.space) : "");
}

std::string source_text(const Plan& plan, const GeneratedProgram& program, const OwnNames& names) {
  std::string text =
      fmt::format("#include \"{}\"\n\n#include <bit>\n#include <cmath>\n#include <limits>\n\n", names.header);
  for (const std::string& header : program.headers) text += fmt::format("#include \"{}\"\n", header);
  text += "\nnamespace {\n\nusing namespace stepwire;\n\n" + program.text + "\n}  // namespace\n\n";
  return text + struct_definitions(plan, names.space);
}

}  // namespace

std::map<std::string, std::string> program_files(const Plan& plan, const std::string& name,
                                                 const std::string& made_by) {
  const GeneratedProgram program = make_program(plan);
  const OwnNames names(name);
  const std::string note =
      fmt::format("// {}\n\n", cpp_comment(fmt::format("{} made this from {}", made_by, plan.diagram.file)));
  std::map<std::string, std::string> files;
  files[names.header] = note + struct_text(plan, names.space);
  files[names.stem + ".cpp"] = note + source_text(plan, program, names);
  files[names.main] = note + main_text(plan, names.header, names.space);
  for (const std::string& header : with_included(program.headers))
    files["stepwire/" + header] = header_text(header);
  files["CMakeLists.txt"] = cmake_text(names, uses_eigen(files));
  return files;
}

}  // namespace stepwire
