#include "engine/generate/program_files.hpp"

#include <fmt/format.h>

#include "engine/generate/compiler.hpp"
#include "engine/generate/diagram_struct.hpp"
#include "engine/generate/headers.hpp"
#include "engine/generate/names.hpp"
#include "engine/generate/program.hpp"
#include "engine/generate/program_main.hpp"

namespace stepwire {

namespace {

std::string cmake_text(const std::string& name) {
  std::string flags;
  for (const std::string& flag : Compiler::flags()) flags += " " + flag;
  return fmt::format(
      "cmake_minimum_required(VERSION 3.16)\n"
      "project({0} LANGUAGES CXX)\n\n"
      "if(NOT CMAKE_BUILD_TYPE)\n  set(CMAKE_BUILD_TYPE Release)\nendif()\n"
      "set(CMAKE_CXX_FLAGS_RELEASE \"\")  # the flags below are all there is to it\n\n"
      "add_executable({0} main.cpp {0}.cpp)\n"
      "target_include_directories({0} PRIVATE ${{CMAKE_SOURCE_DIR}} ${{CMAKE_SOURCE_DIR}}/stepwire)\n"
      "# The same bits as the interpreter's: no contraction, and no rounding by the compiler.\n"
      "target_compile_options({0} PRIVATE{1})\n"
      "if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)  # passes that find little in straight-line code\n"
      "  target_compile_options({0} PRIVATE -fno-tree-pta -fno-tree-slp-vectorize)\n"
      "endif()\n",
      name, flags);
}

std::string source_text(const Plan& plan, const GeneratedProgram& program, const std::string& name) {
  std::string text =
      fmt::format("#include \"{}.hpp\"\n\n#include <bit>\n#include <cmath>\n#include <limits>\n\n", name);
  for (const std::string& header : program.headers) text += fmt::format("#include \"{}\"\n", header);
  text += "\nnamespace {\n\nusing namespace stepwire;\n\n" + program.text + "\n}  // namespace\n\n";
  return text + struct_definitions(plan, name);
}

}  // namespace

std::map<std::string, std::string> program_files(const Plan& plan, const std::string& name,
                                                 const std::string& made_by) {
  const GeneratedProgram program = make_program(plan);
  const std::string own = identifier(name);
  const std::string note = fmt::format("// {} made this from {}.\n\n", made_by, plan.diagram.file);
  std::map<std::string, std::string> files;
  files[own + ".hpp"] = note + struct_text(plan, own);
  files[own + ".cpp"] = note + source_text(plan, program, own);
  files["main.cpp"] = note + main_text(plan, own);
  files["CMakeLists.txt"] = cmake_text(own);
  for (const std::string& header : with_included(program.headers))
    files["stepwire/" + header] = header_text(header);
  return files;
}

}  // namespace stepwire
