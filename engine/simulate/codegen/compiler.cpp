#include "engine/simulate/codegen/compiler.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "engine/base/io/file.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/base/subprocess/process.hpp"

namespace stepwire::codegen {

namespace {

/// Functions that a compiler may evaluate at compile time, with other rounding than the library.
constexpr const char* library_functions[] = {"sin",  "cos",   "tan",  "asin", "acos",  "atan", "atan2",
                                             "sinh", "cosh",  "tanh", "exp",  "expm1", "log",  "log1p",
                                             "log2", "log10", "pow",  "cbrt", "hypot", "fmod"};

constexpr std::chrono::seconds version_limit{5};  // for a compiler that prints its version

constexpr const char* standard_headers = "standard.hpp";

/// Standard headers that headers of blocks include.
constexpr const char* included[] = {"algorithm",  "array",  "cmath",  "complex", "cstdint",
                                    "functional", "limits", "map",    "memory",  "numbers",
                                    "optional",   "span",   "string", "variant", "vector"};

/// Returns the error messages of the compiler; an empty text after success or a stop.
std::string problem_of(const subprocess::ProcessCall& call) {
  const subprocess::ProcessResult result = subprocess::run_process(call);
  return result.end == subprocess::ProcessResult::End::stopped ? "" : result.problem("the compiler");
}

}  // namespace

Compiler::Compiler() {
  std::vector<std::string> candidates{"c++", "g++", "clang++"};
  const char* chosen = std::getenv("CXX");
  if (chosen && *chosen) candidates.insert(candidates.begin(), chosen);
  for (const std::string& candidate : candidates) {
    const subprocess::ProcessResult result =
        subprocess::run_process({.command = {candidate, "--version"}, .limit = version_limit});
    if (result.end == subprocess::ProcessResult::End::overdue) {
      problem_ = fmt::format("{} --version did not end within {} s", candidate, version_limit.count());
      return;
    }
    if (!result.succeeded()) continue;
    path_ = candidate;
    version_ = result.output.substr(0, result.output.find('\n'));
    return;
  }
}

std::vector<std::string> Compiler::flags() {
  // Without errno and traps a square root is one instruction, and branches may become selections.
  std::vector<std::string> flags{
      "-std=c++20", "-O3", "-DNDEBUG", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math"};
  for (const char* function : library_functions) flags.push_back(std::string("-fno-builtin-") + function);
  return flags;
}

bool Compiler::is_gcc() const {
  return version_.find("clang") == std::string::npos;
}

std::vector<std::string> Compiler::command(const std::vector<std::string>& more) const {
  std::vector<std::string> command{path_};
  for (const std::string& flag : flags()) command.push_back(flag);
  if (is_gcc()) command.insert(command.end(), std::begin(gcc_flags), std::end(gcc_flags));
  command.insert(command.end(), more.begin(), more.end());
  command.insert(command.end(), {"-fPIC", "-w"});
  return command;
}

std::string Compiler::compile(const std::string& source, const std::string& library,
                              const std::vector<std::string>& more, const std::stop_token& stop) const {
  std::vector<std::string> command = this->command(more);
  const std::string headers = io::find_resource("precompiled") + "/" + standard_headers;
  // GCC uses a precompiled header only with fitting flags and version; clang rejects that of another one.
  if (is_gcc() && std::filesystem::exists(headers)) command.insert(command.end(), {"-include", headers});
  command.insert(command.end(), {"-I", io::resource("headers"), "-I", io::resource("public")});
  if (const std::string eigen = io::find_resource("eigen"); !eigen.empty())
    command.insert(command.end(), {"-isystem", eigen});
  command.insert(command.end(), {"-shared", "-o", library, source, "-Wl,--as-needed",
                                 std::string("-l:") + elementary_functions});
  return problem_of({.command = command, .stop = stop, .limit = subprocess::compiler_limit()});
}

std::string Compiler::precompile(const std::string& folder, const std::vector<std::string>& more) const {
  if (!is_gcc()) return "";
  const std::string header = folder + "/" + standard_headers;
  std::string text, name = "flags";
  for (const char* of_standard : included) text += std::string("#include <") + of_standard + ">\n";
  for (const std::string& flag : more) name += flag;
  std::filesystem::create_directories(header +
                                      ".gch");  // GCC selects the one that fits from a folder of this name
  io::write_file(header, text);
  std::vector<std::string> command = this->command(more);
  command.insert(command.end(), {"-x", "c++-header", header, "-o", header + ".gch/" + name});
  return problem_of({.command = command, .limit = subprocess::compiler_limit()});
}

}  // namespace stepwire::codegen
