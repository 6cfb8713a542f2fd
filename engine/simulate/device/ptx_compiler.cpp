#include "engine/simulate/device/ptx_compiler.hpp"

#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <regex>
#include <utility>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/simulate/codegen/headers.hpp"

namespace stepwire::device {

namespace {

constexpr const char* candidates[] = {"clang++-22", "clang++-21", "clang++-20",
                                      "clang++-19", "clang++-18", "clang++"};
constexpr int least_version = 18;  // the first with kernels in plain C++
constexpr std::chrono::seconds version_limit{5};

/// Flags of kernels. The target has neither a C library nor its macros, so its headers take those of the
/// processor. Products and sums are not contracted, and the functions of c_library.hpp are called.
constexpr const char* flags[] = {"--target=nvptx64-nvidia-cuda",
                                 "-march=sm_70",
                                 "-std=c++20",
                                 "-O3",
                                 "-DNDEBUG",
                                 "-D_GNU_SOURCE",
                                 "-D__linux__",
                                 "-D__x86_64__",
                                 "-D__LP64__",
                                 "-U__CUDA_ARCH__",
                                 "-D__builtin_ia32_pause()=((void)0)",
                                 "-ffp-contract=off",
                                 "-fno-exceptions",
                                 "-fno-math-errno",
                                 "-fno-trapping-math",
                                 "-fno-builtin-fmod",
                                 "-fno-builtin-remainder",
                                 "-fno-builtin-ldexp",
                                 "-fno-builtin-frexp",
                                 "-fno-builtin-nextafter",
                                 "-fno-builtin-modf",
                                 "-fno-builtin-lround",
                                 "-fno-builtin-memcmp",
                                 "-w",
                                 "-S"};

/// Returns the version in "Debian clang version 19.1.7"; 0 for another text.
int version_of(const std::string& text) {
  static const std::regex form(R"re(clang version (\d+))re");
  std::smatch match;
  return std::regex_search(text, match, form) ? std::stoi(match[1]) : 0;
}

/// Returns options for the folders of the system's headers, which clang does not search for this target.
std::vector<std::string> system_headers(const std::string& compiler) {
  const subprocess::ProcessResult listed = subprocess::run_process(
      {.command = {compiler, "-E", "-v", "-x", "c++", "/dev/null"}, .limit = version_limit});
  std::vector<std::string> options;
  static const std::regex folder(R"re(\n (/[^\n]*))re");
  for (std::sregex_iterator it(listed.errors.begin(), listed.errors.end(), folder), end; it != end; ++it)
    options.insert(options.end(), {"-isystem", (*it)[1]});
  return options;
}

std::string key(const KernelText& kernel, const std::string& version) {
  hash::Hash hash;
  hash.add(kernel.source).add(version);
  for (const char* flag : flags) hash.add(flag);
  for (const std::string& header : codegen::with_included(kernel.headers).all)
    hash.add(codegen::header_text(header));
  return hash.text() + ".ptx";
}

/// Returns the C++ name of a function of an object file.
std::string readable(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), std::free);
  return name ? name.get() : symbol;
}

/// Returns the first error in the compiler's messages.
std::string first_error(const std::string& problem) {
  if (problem.find("Cannot select") != std::string::npos)
    return "a block of it needs an instruction that a device does not have";
  const std::size_t error = problem.find("error: ");
  if (error == std::string::npos) return problem;
  return "a block of it cannot be compiled for a device: " +
         problem.substr(error + 7, problem.find('\n', error) - error - 7);
}

}  // namespace

// The form is ".extern .func (.param .b64 result) name(...", without the parentheses for a function that
// returns nothing. A regular expression would take a second for a large kernel.
std::string unresolved_call(const std::string& ptx) {
  constexpr std::string_view begin = ".extern .func", blank = " \t\r\n";
  std::size_t at = ptx.find(begin);
  if (at == std::string::npos) return "";
  at = ptx.find_first_not_of(blank, at + begin.size());
  if (at != std::string::npos && ptx[at] == '(') at = ptx.find_first_not_of(blank, ptx.find(')', at) + 1);
  if (at == std::string::npos) return "";
  return readable(ptx.substr(at, ptx.find_first_of("( \t\r\n;", at) - at));
}

PtxCompiler::PtxCompiler(io::Cache cache) : cache_(std::move(cache)) {
  for (const char* candidate : candidates) {
    const subprocess::ProcessResult result =
        subprocess::run_process({.command = {candidate, "--version"}, .limit = version_limit});
    if (!result.succeeded() || version_of(result.output) < least_version) continue;
    path_ = candidate;
    version_ = result.output.substr(0, result.output.find('\n'));
    return;
  }
  problem_ = fmt::format("clang of version {} or later is not there; Debian's package clang-19 has it",
                         least_version);
}

std::string PtxCompiler::compile(const KernelText& kernel, const std::stop_token& stop,
                                 std::string& why) const {
  const std::string name = key(kernel, version_);
  std::string ptx;
  if (const auto kept = cache_.find(name)) {
    ptx = *kept;
  } else {
    ptx = made(kernel, stop, why);
    if (!ptx.empty()) cache_.keep(name, ptx);
  }
  const std::string missing = unresolved_call(ptx);
  if (missing.empty()) return ptx;
  why = fmt::format("its code calls {}, which a device does not have", missing);
  return "";
}

/// Compiles a kernel, without the cache.
std::string PtxCompiler::made(const KernelText& kernel, const std::stop_token& stop, std::string& why) const {
  const subprocess::ScratchFolder folder;
  const std::string source = folder.path() + "/kernel.cpp", ptx = folder.path() + "/kernel.ptx";
  io::write_file(source, kernel.source);
  std::vector<std::string> command{path_};
  command.insert(command.end(), std::begin(flags), std::end(flags));
  command.insert(command.end(), {"-I", io::resource("headers"), "-I", io::resource("public")});
  if (const std::string eigen = io::find_resource("eigen"); !eigen.empty())
    command.insert(command.end(), {"-isystem", eigen});
  std::ranges::copy(system_headers(path_), std::back_inserter(command));
  command.insert(command.end(), {"-o", ptx, source});
  const subprocess::ProcessResult result =
      subprocess::run_process({.command = command, .stop = stop, .limit = subprocess::compiler_limit()});
  if (result.succeeded()) return io::read_file(ptx);
  if (result.end != subprocess::ProcessResult::End::stopped) why = first_error(result.problem("clang"));
  return "";
}

}  // namespace stepwire::device
