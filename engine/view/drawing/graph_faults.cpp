#include "engine/view/drawing/graph_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/base/yaml/error.hpp"

namespace stepwire::drawing {

namespace {

using Keys = std::vector<std::string>;

/// Returns "It has: a, b, c"; of many names the first ones.
std::string listing(const std::string& opening, const Keys& names, const std::string& none) {
  constexpr std::size_t most = 24;
  if (names.empty()) return none;
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size()));
  return fmt::format("{}: {}{}", opening, fmt::join(names.begin(), end, ", "),
                     names.size() > most ? ", ..." : "");
}

/// Looks names up and collects the unknown ones.
class OptionChecker {
 public:
  OptionChecker(const DiagramView& view, const GraphOptions& options) : view_(view), options_(options) {}

  std::vector<GraphFault> check() {
    const Keys parts = view_.parts();
    for (const std::string& part : options_.open) require("open", "part", part, parts, "It has no parts");
    check_hidden();
    if (!options_.names.empty()) {
      const Keys blocks = view_.blocks(false);
      for (const auto& [block, name] : options_.names)
        require("names", "block or part", block, blocks, "It has no blocks");
    }
    check_labels();
    check_groups();
    return std::move(faults_);
  }

 private:
  void require(const std::string& key, const std::string& what, const std::string& word, const Keys& names,
               const std::string& none) {
    if (std::ranges::find(names, word) != names.end()) return;
    const std::string all = listing("It has", names, none);
    faults_.push_back(
        {key, word, fmt::format("there is no {} '{}'", what, word) + yaml::did_you_mean(word, names, all)});
  }

  void check_hidden() {
    if (options_.hide.empty()) return;
    const Keys names = view_.blocks(true);
    for (const std::string& pattern : options_.hide) {
      const auto follows = [&](const std::string& name) { return follows_pattern(name, pattern); };
      if (std::ranges::none_of(names, follows))
        require("hide", "block, part or signal", pattern, names, "It has no blocks");
    }
  }

  void check_labels() {
    if (options_.labels.empty() || !faults_.empty()) return;
    const Keys drawn = view_.signals(options_), known = view_.blocks(true);
    for (const auto& [signal, text] : options_.labels) {
      if (std::ranges::find(drawn, signal) != drawn.end()) continue;
      const std::string all = listing("Drawn are", drawn, "Nothing is drawn");
      const bool exists = std::ranges::find(known, signal) != known.end();
      const std::string what = exists ? fmt::format("no wire is drawn that is '{}' alone", signal)
                                      : fmt::format("there is no signal '{}'", signal);
      faults_.push_back({"labels", signal, what + yaml::did_you_mean(signal, drawn, all)});
    }
  }

  void check_groups() {
    if (options_.groups.empty()) return;
    const Keys children = view_.children();
    std::set<std::string> taken;
    for (const NodeGroup& group : options_.groups)
      for (const std::string& member : group.members) {
        require("groups", "block or part of the file itself", member, children, "It has no blocks");
        if (!taken.insert(member).second)
          faults_.push_back(
              {"groups", member, fmt::format("'{}' is in two groups; one can hold it", member)});
      }
  }

  const DiagramView& view_;
  const GraphOptions& options_;
  std::vector<GraphFault> faults_;
};

}  // namespace

std::vector<GraphFault> faults_of(const DiagramView& view, const GraphOptions& options) {
  return OptionChecker(view, options).check();
}

}  // namespace stepwire::drawing
