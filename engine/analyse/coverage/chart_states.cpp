#include "engine/analyse/coverage/chart_states.hpp"

#include <algorithm>

namespace stepwire::coverage {

namespace {

struct ReadState {
  std::string name;
  const Value* tree;
};

void gather(const Value& states, const std::string& parent, std::vector<ReadState>& all) {
  if (!states.map()) return;
  for (const auto& [name, tree] : *states.map()) {
    const std::string full = parent.empty() ? name : parent + "." + name;
    all.push_back({full, &tree});
    if (const Value* inner = tree.find("states")) gather(*inner, full, all);
  }
}

/// Finds a state as the block does: beside or within the state, then in the states that hold it.
std::size_t find(const std::vector<ReadState>& all, const std::string& name, std::string holder) {
  for (;; holder.resize(holder.find('.') == std::string::npos ? 0 : holder.rfind('.'))) {
    const std::string full = holder.empty() ? name : holder + "." + name;
    const auto at = std::ranges::find(all, full, &ReadState::name);
    if (at != all.end() || holder.empty()) return static_cast<std::size_t>(at - all.begin());
  }
}

/// Returns the names of the targets of a state.
std::vector<std::string> targets_of(const Value& tree) {
  std::vector<std::string> names;
  for (const char* key : {"to", "timeout"}) {
    const Value* to = tree.find(key);
    if (to && to->map())
      for (const auto& [name, guard] : *to->map()) names.push_back(name);
    if (to && to->list())
      for (const Value& entry : *to->list())
        if (const Value* name = entry.find("to"); name && name->text()) names.push_back(*name->text());
  }
  return names;
}

}  // namespace

bool Chart::is_within(std::size_t state, std::size_t holder) const {
  return state == holder || states[state].starts_with(states[holder] + ".");
}

Chart chart_of(const diagram::DiagramBlock& block) {
  const ParameterSpec* states = block.type().parameter("states");
  if (!states || states->kind != ParameterKind::tree || block.type().output("state") < 0) return {};
  const Value tree = states->get(block.block.get());
  std::vector<ReadState> all;
  gather(tree, "", all);
  Chart chart;
  for (std::size_t i = 0; i < all.size(); ++i) {
    chart.states.push_back(all[i].name);
    for (const std::string& target : targets_of(*all[i].tree))
      if (const std::size_t to = find(all, target, all[i].name); to < all.size())
        chart.arrows.push_back({i, to});
  }
  return chart;
}

}  // namespace stepwire::coverage
