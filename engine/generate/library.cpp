#include "engine/generate/library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "engine/generate/headers.hpp"
#include "engine/table/cache.hpp"
#include "engine/table/file.hpp"

namespace stepwire {

namespace {

namespace fs = std::filesystem;

/// What tells this machine's processor from others.
std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  std::string text, line;
  while (std::getline(info, line) && !line.empty())  // the first core
    for (const char* field : {"model name", "flags", "Features", "CPU part"})
      if (line.starts_with(field)) text += line + "\n";
  return text;
}

StepFunctions open_library(const std::string& path, std::string& problem) {
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    problem = ::dlerror();
    return {};
  }
  StepFunctions functions;
  functions.evaluate = reinterpret_cast<decltype(functions.evaluate)>(::dlsym(library, "stepwire_evaluate"));
  functions.advance = reinterpret_cast<decltype(functions.advance)>(::dlsym(library, "stepwire_advance"));
  return functions;
}

}  // namespace

std::vector<std::string> flags_for_this_machine(const std::vector<std::string>& headers) {
  for (const std::string& header : with_included(headers))
    if (header_text(header).find("#include <Eigen/") != std::string::npos) return {};
  return {Compiler::native};
}

std::string library_source(const GeneratedProgram& program) {
  std::string source =
      "#define STEPWIRE_GENERATED\n#include <cmath>\n#include <cstdint>\n#include <limits>\n\n";
  for (const std::string& header : program.headers) source += fmt::format("#include \"{}\"\n", header);
  source += "\nnamespace {\n\nusing namespace stepwire;\n\n" + program.text + "\n}  // namespace\n\n";
  for (const char* function : {"evaluate", "advance"})
    source += fmt::format(
        "extern \"C\" [[gnu::flatten]] void stepwire_{0}(double* w, const double* parameters, std::int64_t "
        "tick) "
        "{{\n  {0}(w, parameters, tick);\n}}\n",
        function);
  return source;
}

CodeCache::CodeCache() : CodeCache(cache_folder()) {}

std::string CodeCache::key(const std::string& source, const GeneratedProgram& program,
                           const Compiler& compiler) const {
  std::uint64_t hash = hash_of(source);
  const std::vector<std::string> headers = with_included(program.headers);
  for (const std::string& header : headers) hash = hash_of(header_text(header), hash);
  for (const std::string& flag : Compiler::flags()) hash = hash_of(flag, hash);
  for (const std::string& flag : flags_for_this_machine(program.headers))
    hash = hash_of(flag + processor(), hash);
  hash = hash_of(compiler.version(), hash);
  return fmt::format("{:016x}{:08x}", hash, source.size());
}

StepFunctions CodeCache::load(const GeneratedProgram& program, const Compiler& compiler,
                              const std::stop_token& stop, std::string& problem) const {
  try {
    const std::string source = library_source(program);
    const std::string path = fmt::format("{}/{}.so", folder_, key(source, program, compiler));
    const std::vector<std::string> flags = flags_for_this_machine(program.headers);
    if (!fs::exists(path) && !make(source, path, flags, compiler, stop, problem)) return {};
    fs::last_write_time(path, fs::file_time_type::clock::now());  // used just now
    return open_library(path, problem);
  } catch (const std::exception& error) {  // no folder, no room, no sources: the run goes on without
    problem = error.what();
    return {};
  }
}

bool CodeCache::make(const std::string& source, const std::string& library,
                     const std::vector<std::string>& flags, const Compiler& compiler,
                     const std::stop_token& stop, std::string& problem) const {
  fs::create_directories(folder_);
  drop_old();
  const std::string own = fmt::format("{}.{}", library, ::getpid());  // two runs may make the same at a time
  write_file(own + ".cpp", source);
  problem = compiler.compile(own + ".cpp", own, flags, stop);
  fs::remove(own + ".cpp");
  if (problem.empty()) {
    fs::rename(own, library);
  } else {
    fs::remove(own);
  }
  return problem.empty();
}

void CodeCache::drop_old() const {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::uintmax_t bytes = 0;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, none)) {
    bytes += entry.file_size(none);
    files.emplace_back(entry.last_write_time(none), entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& [time, path] : files) {
    if (bytes <= most_bytes_) return;
    bytes -= std::min(bytes, fs::file_size(path, none));
    fs::remove(path, none);
  }
}

}  // namespace stepwire
