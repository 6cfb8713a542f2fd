#include "engine/app/mcp/tool_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>

#include "engine/base/io/cache.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/inside.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::mcp {
namespace {

namespace fs = std::filesystem;

std::string existing_folder(const json::Json& named, const std::string& root) {
  const std::string* const text = named.as_text();
  if (!text || text->empty()) throw CallFault("'folder' is the path of a folder, as text");
  std::error_code error;
  const std::string path = fs::canonical(*text, error).string();
  if (error || !fs::is_directory(path))
    throw CallFault(fmt::format("folder: there is no folder '{}'", text::visible(*text)));
  if (!io::is_below(path, root))
    throw CallFault(fmt::format("folder: '{}' is not below {}, to which this server is limited",
                                text::visible(*text), root));
  if (path.find(':') != std::string::npos)
    throw CallFault("folder: the path of a folder has no ':'; rename it");
  return path;
}

std::string shown_name(std::size_t index, std::size_t count) {
  return count == 1 ? "text.yaml" : fmt::format("text-{}.yaml", index + 1);
}

}  // namespace

ToolFolder::ToolFolder(const json::Json* named, const std::string& root) {
  if (named) {
    path_ = existing_folder(*named, root);
    return;
  }
  path_ = scratch_.path() + "/folder";
  std::error_code error;
  if (scratch_.path().empty() || !fs::create_directory(path_, error))
    throw io::EnvironmentError("no temporary folder can be made; name a 'folder'");
}

ToolFolder::~ToolFolder() {
  std::error_code ignored;
  for (const std::string& name : texts_) fs::remove(fs::path(path_) / name, ignored);
}

std::string ToolFolder::checked(const std::string& path) const {
  const auto refuse = [&](const char* why) {
    throw CallFault(fmt::format("'{}' {}", text::visible(path), why));
  };
  if (path.empty() || path == "-" || path.find('\0') != std::string::npos) refuse("is no path of a file");
  if (fs::path(path).is_absolute()) refuse("is an absolute path; files are named relative to 'folder'");
  if (!io::is_below((fs::path(path_) / path).string(), path_))
    refuse("leads out of the folder of the call; files are below it alone");
  return path.front() == '-' ? "./" + path : path;
}

std::string ToolFolder::add_text(const std::string& text) {
  static std::atomic<unsigned> count = 0;
  const std::string name = fmt::format(".stepwire-text-{}-{}.yaml", ::getpid(), count++);
  try {
    io::write_file((fs::path(path_) / name).string(), text);
  } catch (const io::EnvironmentError& error) {
    throw CallFault(fmt::format("the text cannot be written into the folder: {}", error.what()));
  }
  texts_.push_back(name);
  return name;
}

std::string ToolFolder::shown(std::string output) const {
  for (std::size_t i = 0; i < texts_.size(); ++i)
    text::replace_all(output, texts_[i], shown_name(i, texts_.size()));
  return output;
}

std::string ToolFolder::readable() const {
  std::string folders = path_ + ":" + io::cache_folder() + ":" + scratch_.path();
  for (const char* name : {"headers", "public", "eigen", "precompiled", "drawing", "diagrams", "mpi"})
    if (const std::string found = io::find_resource(name); !found.empty()) folders += ":" + found;
  for (const char* variable : {"STEPWIRE_PARTS", "STEPWIRE_BLOCKS"})
    if (const char* const named = std::getenv(variable)) folders += ":" + std::string(named);
  return folders;
}

}  // namespace stepwire::mcp
