#include "engine/simulate/blockset/blockset.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/cache.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/math/floating_point.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/headers.hpp"
#include "engine/simulate/codegen/library.hpp"

namespace stepwire::blockset {

namespace {

namespace fs = std::filesystem;

/// Mangled name of void register_blocks(stepwire::Registry&) by g++ and clang++.
constexpr const char* registration = "_Z15register_blocksRN8stepwire8RegistryE";

[[noreturn]] void refuse(const std::string& folder, const std::string& message) {
  throw yaml::Error(yaml::Fault{{folder, {}}, "", message, {}});
}

bool is_source(const fs::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".cpp" || ending == ".cc" || ending == ".cxx";
}

/// Returns the sources in a folder and its subfolders, without hidden ones, in sorted order.
std::vector<std::string> sources_in(const std::string& folder) {
  std::vector<std::string> sources;
  for (auto it = fs::recursive_directory_iterator(folder); it != fs::recursive_directory_iterator(); ++it) {
    const bool hidden = it->path().filename().string().starts_with('.');
    if (hidden && it->is_directory()) it.disable_recursion_pending();
    if (!hidden && it->is_regular_file() && is_source(it->path())) sources.push_back(it->path().string());
  }
  if (sources.empty()) refuse(folder, "there is no .cpp file in this folder, so there are no blocks");
  std::ranges::sort(sources);
  return sources;
}

std::vector<std::string> flags_of(const std::string& folder, const codegen::IncludedHeaders& headers) {
  std::vector<std::string> flags = codegen::include_options(headers);
  // -Bsymbolic binds the library to its own symbols, even if the executable has the same ones.
  flags.insert(flags.end(), {"-idirafter", folder, "-Wl,-Bsymbolic", "-DSTEPWIRE_BLOCKS_FROM_OUTSIDE"});
  return flags;
}

std::string key_of(const std::vector<std::string>& sources, const codegen::IncludedHeaders& headers,
                   const std::vector<std::string>& flags, const codegen::Compiler& compiler) {
  hash::Hash hash;
  hash.add("blocks");
  for (const std::string& source : sources) hash.add(source).add(io::read_file(source));
  for (const std::string& header : headers.all) hash.add(header).add(codegen::header_text(header));
  for (const std::string& flag : codegen::Compiler::flags()) hash.add(flag);
  for (const std::string& flag : flags) hash.add(flag);
  return hash.add(compiler.version()).text();
}

/// Throws the errors of the compiler, each with its place; the complete output if no line has a place.
[[noreturn]] void refuse_sources(const std::string& folder, const std::string& said) {
  static const std::regex complaint(R"re(^(.+?):(\d+):(\d+): (?:fatal )?error: (.*)$)re");
  std::vector<yaml::Fault> faults;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, complaint))
      faults.push_back({{match[1], {std::stoi(match[2]), std::stoi(match[3])}}, "", match[4].str(), {}});
  }
  if (!faults.empty()) throw yaml::Error(std::move(faults));
  refuse(folder, "the blocks of this folder cannot be compiled: " + said);
}

std::string compiled(const std::string& folder, const std::vector<std::string>& sources,
                     std::vector<std::string> flags, const codegen::Compiler& compiler) {
  const subprocess::ScratchFolder scratch;
  const std::string library = scratch.path() + "/blocks.so";
  flags.insert(flags.end(), sources.begin(), std::prev(sources.end()));
  const std::string said = compiler.compile(sources.back(), library, flags, {});
  if (!said.empty()) refuse_sources(folder, said);
  if (!fs::exists(library)) throw subprocess::ProcessStopped("the compiler was stopped");
  return io::read_file(library);
}

void* load(const std::string& folder, const std::string& bytes) {
  std::string problem;
  void* library = codegen::load_library(bytes, problem);
  if (!library) refuse(folder, "the blocks of this folder cannot be loaded: " + problem);
  return library;
}

/// Sources of a folder, and how they are compiled.
struct Build {
  explicit Build(const std::string& folder) {
    if (!compiler.found()) throw io::EnvironmentError(folder + ": " + compiler.problem());
    sources = sources_in(folder);
    headers = codegen::with_included(sources);
    flags = flags_of(folder, headers);
  }

  std::string hash() const { return key_of(sources, headers, flags, compiler); }

  codegen::Compiler compiler;
  std::vector<std::string> sources;
  codegen::IncludedHeaders headers;
  std::vector<std::string> flags;
};

/// Returns the compiled blocks of a folder, from the cache or newly compiled.
void* library_of(const std::string& folder) {
  const Build build(folder);
  const std::string key = build.hash() + ".so";
  const io::Cache cache;
  if (const auto kept = cache.find(key)) return load(folder, *kept);
  const std::string made = compiled(folder, build.sources, build.flags, build.compiler);
  void* library = load(folder, made);
  cache.keep(key, made);
  return library;
}

}  // namespace

std::string blockset_hash(const std::string& folder) {
  return Build(folder).hash();
}

void load_blockset(const std::string& path, Registry& registry) {
  std::error_code problem;
  const std::string folder = fs::canonical(path, problem).string();
  if (problem || !fs::is_directory(folder)) throw io::EnvironmentError(path + ": is no folder with blocks");
  if (folder.find_first_of("\"\\\n\r") != folder.npos)
    refuse(folder, "has a character that no #include can name");
  void* library = library_of(folder);
  const auto add = reinterpret_cast<void (*)(Registry&)>(::dlsym(library, registration));
  if (!add)
    refuse(folder,
           "no source here defines 'void register_blocks(stepwire::Registry&)', outside of any namespace");
  const FloatingPointState kept;
  try {
    add(registry);
  } catch (const std::exception& error) {
    refuse(folder, fmt::format("register_blocks() of these blocks throws: {}", error.what()));
  } catch (...) {
    refuse(folder, "register_blocks() of these blocks throws what is no std::exception");
  }
  registry.note_blockset(folder);
}

void load_blocksets_of_environment(Registry& registry) {
  const char* listed = std::getenv("STEPWIRE_BLOCKS");
  std::istringstream folders(listed ? listed : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty()) load_blockset(folder, registry);
}

}  // namespace stepwire::blockset
