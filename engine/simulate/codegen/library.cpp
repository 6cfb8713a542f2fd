#include "engine/simulate/codegen/library.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/math/floating_point.hpp"
#include "engine/base/subprocess/fork.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/simulate/codegen/headers.hpp"

namespace stepwire::codegen {

namespace {

namespace fs = std::filesystem;

/// Returns a text that identifies this machine's processor model.
std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  std::string text, line;
  while (std::getline(info, line) && !line.empty())  // fields of the first core
    for (const char* field : {"model name", "flags", "Features", "CPU part"})
      if (line.starts_with(field)) text += line + "\n";
  return text;
}

/// Creates a sealed file in memory with these bytes. Returns -1 on failure.
int sealed_file(std::string_view bytes) {
  const int file = ::memfd_create("stepwire", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  while (file >= 0 && !bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written <= 0) {
      ::close(file);
      return -1;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  ::fcntl(file, F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL);
  return file;
}

ProgramFunctions open_library(const std::string& bytes, std::string& problem) {
  void* library = load_library(bytes, problem);
  if (!library) return {};
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(::dlsym(library, name));
  };
  ProgramFunctions functions;
  find(functions.steps.evaluate, "stepwire_evaluate");
  find(functions.steps.advance, "stepwire_advance");
  find(functions.run, "stepwire_run");
  return functions;
}

std::string key(const std::string& source, const GeneratedProgram& program, const Compiler& compiler) {
  hash::Hash hash;
  hash.add(source);
  for (const std::string& header : with_included(program.headers).all) hash.add(header_text(header));
  for (const std::string& flag : Compiler::flags()) hash.add(flag);
  for (const char* flag : Compiler::gcc_flags) hash.add(flag);
  for (const std::string& flag : flags_of(program)) hash.add(flag).add(processor());
  return hash.add(compiler.version()).text() + ".so";
}

/// Returns the bytes of the compiled library; empty on failure.
std::string compiled(const std::string& source, const GeneratedProgram& program, const Compiler& compiler,
                     const std::stop_token& stop, std::string& problem) {
  std::vector<std::string> flags = flags_of(program);
  std::ranges::copy(include_options(with_included(program.headers)), std::back_inserter(flags));
  const subprocess::ScratchFolder folder;
  const std::string library = folder.path() + "/program.so";
  io::write_file(folder.path() + "/program.cpp", source);
  problem = compiler.compile(folder.path() + "/program.cpp", library, flags, stop);
  return problem.empty() && fs::exists(library) ? io::read_file(library) : "";
}

}  // namespace

// Loads a library. The file in memory stays open, since the loader identifies files by their number and would
// confuse a later file with it.
void* load_library(const std::string& bytes, std::string& problem) {
  const int file = sealed_file(bytes);
  const std::lock_guard lock(subprocess::loader_mutex());
  const FloatingPointState kept;  // -ffast-math code changes the state when loaded
  void* library = ::dlopen(fmt::format("/proc/self/fd/{}", file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library) return library;
  problem = ::dlerror();
  if (file >= 0) ::close(file);
  return nullptr;
}

std::vector<std::string> library_flags() {
  return {"-fvisibility=hidden", "-fvisibility-inlines-hidden", "-Wl,-Bsymbolic"};
}

std::vector<std::string> flags_of(const GeneratedProgram& program) {
  std::vector<std::string> flags = flags_for_this_machine(program.headers);
  std::ranges::copy(library_flags(), std::back_inserter(flags));
  if (program.lanes == 1) return flags;
  flags.push_back("-fopenmp-simd");
  // A loop over lanes is vectorised only if all its calls are inlined, of any size.
  for (const char* limit :
       {"max-inline-insns-single", "large-function-growth", "large-stack-frame-growth", "inline-unit-growth"})
    flags.push_back(fmt::format("--param={}=100000", limit));
  // Copies in pieces narrower than a register stall the next read of that register.
  flags.insert(flags.end(), {"-ftree-pta", "-ftree-slp-vectorize", "-fno-tree-loop-distribute-patterns"});
  flags.push_back(fmt::format("-mprefer-vector-width={}", 64 * program.lanes));
  return flags;
}

std::vector<std::string> flags_for_this_machine(const std::vector<std::string>& headers) {
  // Standard headers have neither folder nor extension. The includes of any other header are unknown.
  static const std::regex foreign(R"re(#[ \t]*include[ \t]*<(?!stepwire/)[^>\n]*[/.])re");
  for (const std::string& header : with_included(headers).all)
    if (std::regex_search(header_text(header), foreign)) return {};
  return {Compiler::native};
}

std::string library_head(const std::vector<std::string>& headers, int lanes, bool uses_libm) {
  std::string head = lanes == 1 ? "" : fmt::format("#define STEPWIRE_LANES {}\n", lanes);
  head += uses_libm ? "#define STEPWIRE_LIBM\n" : "#define STEPWIRE_SLEEF\n";
  head += "#define STEPWIRE_GENERATED\n#include <cmath>\n#include <cstdint>\n#include <limits>\n\n";
  head += lanes == 1 ? "#define stepwire stepwire_compiled\n" : "#define stepwire stepwire_in_lanes\n";
  for (const std::string& header : headers) head += fmt::format("#include \"{}\"\n", header);
  return head;
}

std::string library_source(const GeneratedProgram& program) {
  std::string source = library_head(program.headers, program.lanes, program.uses_libm);
  source += "\nnamespace {\n\nusing namespace stepwire;\n\n" + program.text + "\n}  // namespace\n\n";
  const std::string exported = "extern \"C\" [[gnu::flatten, gnu::visibility(\"default\")]] void stepwire_";
  if (program.lanes > 1) return source + exported + "run(plan::LaneTask& task) {\n  run(task);\n}\n";
  for (const char* function : {"evaluate", "advance"})
    source += exported + fmt::format(
                             "{0}(double* w, const double* numbers, std::int64_t tick) {{\n"
                             "  {0}(w, numbers, tick);\n}}\n",
                             function);
  return source;
}

ProgramFunctions CodeCache::load(const GeneratedProgram& program, const Compiler& compiler,
                                 const plan::CodeLimits& limits, const Trial& trial,
                                 std::string& problem) const {
  try {
    const std::string source = library_source(program), name = key(source, program, compiler);
    if (const auto kept = cache_.find(name)) return open_library(*kept, problem);
    if (limits.only_kept) return {};
    const std::string made = compiled(source, program, compiler, limits.stop, problem);
    if (made.empty()) return {};
    const ProgramFunctions functions = open_library(made, problem);
    if (!functions) return {};
    problem = trial(functions);
    if (!problem.empty()) return {};
    cache_.keep(name, made);
    return functions;
  } catch (const std::exception& error) {  // the run continues interpreted
    problem = error.what();
    return {};
  }
}

}  // namespace stepwire::codegen
