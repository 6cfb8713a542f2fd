// Packages from the npm registry run on the node of Debian 12, and are pinned.
#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/house/source_tree.hpp"

namespace {

using nlohmann::json;
using Version = std::array<int, 3>;

constexpr Version node_of_debian{18, 19, 0};  // the first one of Debian 12

/// "18", "18.1" and "18.1.0", with zeros for what is not there.
Version version_of(const std::string& text) {
  Version version{};
  std::stringstream parts(text);
  std::string part;
  for (std::size_t i = 0; i < version.size() && std::getline(parts, part, '.'); ++i)
    version[i] = std::atoi(part.c_str());
  return version;
}

/// One condition of a range, such as ">=18.0.0", "^18" and "18.x".
bool holds(const std::string& condition, const Version& version) {
  static const std::regex form(R"((>=|<=|>|<|\^|~|=|)v?([\dx*.]+)(-\S*)?)");
  std::smatch match;
  if (!std::regex_match(condition, match, form)) return false;
  const std::string sign = match[1], number = match[2];
  if (number == "*" || number == "x") return true;
  const Version other = version_of(number);
  if (sign == ">=") return version >= other;
  if (sign == "<=") return version <= other;
  if (sign == ">") return version > other;
  if (sign == "<") return version < other;
  if (sign == "~") return version >= other && version[0] == other[0] && version[1] == other[1];
  return version[0] == other[0] && (sign == "^" ? version >= other : true);
}

/// A range as package.json has it: alternatives of conditions.
bool contains(std::string range, const Version& version) {
  range = std::regex_replace(range, std::regex(R"((>=|<=|>|<|\^|~|=)\s+)"), "$1");
  const std::regex alternative(R"([^|]+)"), condition(R"(\S+)");
  for (std::sregex_iterator one(range.begin(), range.end(), alternative), end; one != end; ++one) {
    const std::string all = one->str();
    bool fits = true;
    for (std::sregex_iterator at(all.begin(), all.end(), condition); at != end; ++at)
      fits = fits && holds(at->str(), version);
    if (fits) return true;
  }
  return range.empty();
}

std::vector<std::string> lock_files() {
  std::vector<std::string> files;
  for (const std::string& file : files_under(""))
    if (file.ends_with("package-lock.json")) files.push_back(file);
  return files;
}

json read(const std::string& file) {
  return json::parse(std::ifstream(std::filesystem::path(STEPWIRE_SOURCE_DIR) / file));
}

/// The package.json of a lock file.
json wishes_of(const std::string& lock_file) {
  return read(lock_file.substr(0, lock_file.size() - std::string("-lock.json").size()) + ".json");
}

}  // namespace

TEST_CASE("a range of versions is read as npm reads it") {
  for (const std::string range : {"*", "", ">=18", ">= 18.0.0", "^18.0.0 || ^20.0.0 || >=22.0.0", "18 || 20",
                                  "18.x", ">=12 <19", "^10 || ^12 || >=14", "~18.19.0"}) {
    INFO(range);
    CHECK(contains(range, {18, 19, 0}));
  }
  for (const std::string range :
       {">=20", ">18.20", "^18.20.0", "^20 || >=22", "<18", ">=12 <18", "20.x", ">=18.19.1", "~18.18.0"}) {
    INFO(range);
    CHECK_FALSE(contains(range, {18, 19, 0}));
  }
}

TEST_CASE("no package that is installed wants more than Debian's node") {
  REQUIRE(lock_files().size() > 2);
  for (const std::string& file : lock_files()) {
    const json packages = read(file).at("packages");
    for (const auto& [name, package] : packages.items()) {
      if (!package.contains("engines") || !package["engines"].contains("node")) continue;
      INFO(file << ": " << name << " wants node " << package["engines"]["node"]);
      CHECK(contains(package["engines"]["node"], node_of_debian));
    }
  }
}

TEST_CASE("no package.json overrides a package by another name, which Debian's npm 9.2.0 refuses") {
  for (const std::string& file : lock_files()) {
    INFO(file);
    CHECK_FALSE(wishes_of(file).value("overrides", json::object()).dump().find("npm:") != std::string::npos);
  }
}

TEST_CASE("every package has one version and the hash of its content") {
  for (const std::string& file : lock_files()) {
    const json packages = read(file).at("packages"), wanted = wishes_of(file);
    for (const auto& [name, package] : packages.items()) {
      INFO(file << ": " << name);
      CHECK((name.empty() || (package.contains("integrity") && package.contains("version"))));
    }
    for (const char* kind : {"dependencies", "devDependencies"}) {
      const json versions = wanted.value(kind, json::object());
      for (const auto& [name, version] : versions.items()) {
        INFO(file << ": " << name << " " << version);
        CHECK(std::regex_match(version.get<std::string>(), std::regex(R"((npm:@?[^@]+@)?\d+\.\d+\.\d+)")));
      }
    }
  }
}
