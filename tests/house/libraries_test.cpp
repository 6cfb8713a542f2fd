#include <algorithm>
#include <catch2/catch.hpp>
#include <regex>
#include <string>
#include <vector>

#include "tests/house/source_tree.hpp"

namespace {

/// A library and the one folder that may include it.
struct Home {
  std::string prefix, folder;
  std::vector<std::string> others{};  ///< Further folders, whose files have the same form.
};

// The first that fits counts. Eigen, fmt and the standard library are at home everywhere.
const std::vector<Home> homes{
    {"boost/math/tools/minima", "engine/analyse/linear"},
    {"boost/math/", "engine/analyse/statistics"},
    {"boost/random/", "engine/base/sampling"},
    {"boost/lockfree/", "engine/simulate/realtime"},
    {"boost/geometry", "blocks/haptics/region"},
    {"boost/polygon/", "engine/view/geometry"},
    {"boost/beast/", "engine/app/studio/http"},
    {"boost/asio/", "engine/app/studio/http"},
    {"boost/", "engine/model/plan"},
    {"yaml-cpp/", "engine/base/yaml"},
    {"udunits2", "engine/base/unit"},
    {"hdf5", "engine/base/hdf5"},
    {"nlohmann/", "engine/base/json"},
    {"CLI/", "engine/app/cli"},
    {"ceres/", "engine/analyse/estimation"},
    {"glog/", "engine/analyse/estimation"},
    {"nlopt", "engine/analyse/tuning"},
    {"zip.h", "engine/base/archive"},
    {"pugixml", "engine/base/fmi", {"engine/base/junit", "engine/app/simulink"}},
    {"pybind11/", "engine/app/python"},
    {"Python.h", "engine/app/python"},
    {"xxhash", "engine/base/hash"},
    {"sha256.h", "engine/base/hash"},
};

const Home* home_of(const std::string& header) {
  for (const Home& home : homes)
    if (header.starts_with(home.prefix)) return &home;
  return nullptr;
}

/// An include of such a library.
struct Use {
  Line line;
  const Home* home;
};

std::vector<Use> uses() {
  const std::regex include(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
  std::vector<Use> found;
  for (const std::string& file : sources_under({"engine", "blocks"}))
    for (const Line& line : lines_of(file)) {
      std::smatch match;
      if (!std::regex_search(line.text, match, include)) continue;
      if (const Home* home = home_of(match[1])) found.push_back({line, home});
    }
  return found;
}

}  // namespace

TEST_CASE("each library is included in one folder only") {
  for (const Use& use : uses()) {
    INFO(use.line.place() << ": " << use.line.text);
    const std::string folder = folder_of(use.line.file);
    CHECK((folder == use.home->folder || std::ranges::count(use.home->others, folder) == 1));
  }
}

TEST_CASE("no header of ours includes a library that is heavy to compile") {
  for (const Use& use : uses()) {
    INFO(use.line.place() << ": " << use.line.text);
    CHECK(use.line.file.ends_with(".cpp"));
  }
}
