#include "engine/view/drawing/chart_graph.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace stepwire::drawing {

namespace {

using json::Json;

constexpr std::size_t longest_guard = 28;

struct ChartNode {
  std::string name, parent;  ///< full names
  const Value* tree;
  bool holds = false;
  std::vector<std::pair<std::string, std::string>> to;  ///< target state and guard
};

/// Returns the text of a guard, shortened to fit beside an arrow.
std::string guard_text(const Value& guard) {
  const std::string text = guard.text() ? *guard.text() : "";
  return text.size() > longest_guard ? text.substr(0, longest_guard - 1) + "…" : text;
}

class ChartWriter {
 public:
  ChartWriter(const Value& states, std::string id) : id_(std::move(id)) {
    gather(states, "");
    for (ChartNode& node : nodes_) read_transitions(node);
  }

  Json graph() {
    Json nodes = Json::list(), wires = Json::list(), groups = Json::list();
    for (const ChartNode& node : nodes_) {
      nodes.push(state(node));
      for (std::size_t t = 0; t < node.to.size(); ++t)
        if (node.to[t].first != node.name)
          wires.push(Json::object()
                         .set("from", end(node.name, "to." + std::to_string(t + 1)))
                         .set("to", end(node.to[t].first, entry(node, t))));
      if (node.holds && node.parent.empty()) groups.push(group(node));
    }
    return Json::object()
        .set("inputs", Json::list())
        .set("outputs", Json::list())
        .set("nodes", std::move(nodes))
        .set("wires", std::move(wires))
        .set("groups", std::move(groups));
  }

 private:
  void gather(const Value& states, const std::string& parent) {
    if (!states.map()) return;
    for (const auto& [name, tree] : *states.map()) {
      const std::string full = parent.empty() ? name : parent + "." + name;
      const Value* inner = tree.find("states");
      nodes_.push_back({full, parent, &tree, inner != nullptr, {}});
      if (!inner || !inner->map() || inner->map()->empty()) continue;
      const Value* initial = tree.find("initial");
      const std::string first = initial && initial->text() ? *initial->text() : inner->map()->front().key;
      nodes_.back().to.emplace_back(full + "." + first, "");
      gather(*inner, full);
    }
  }

  void read_transitions(ChartNode& node) {
    const auto add = [&](const std::string& name, const std::string& guard) {
      if (const std::string target = find(name, node.name); !target.empty())
        node.to.emplace_back(target, guard);
    };
    const Value *to = node.tree->find("to"), *timeout = node.tree->find("timeout");
    if (to && to->map())
      for (const auto& [name, guard] : *to->map()) add(name, guard_text(guard));
    if (to && to->list())
      for (const Value& entry : *to->list())
        if (const Value* name = entry.find("to"), *when = entry.find("when"); name && name->text() && when)
          add(*name->text(), guard_text(*when));
    if (timeout && timeout->map())
      for (const auto& [name, time] : *timeout->map()) add(name, "after " + guard_text(time));
  }

  /// Finds a state as the block does: beside or within the state, then in the states that hold it.
  std::string find(const std::string& name, std::string holder) const {
    for (;; holder.resize(holder.find('.') == std::string::npos ? 0 : holder.rfind('.'))) {
      const std::string full = holder.empty() ? name : holder + "." + name;
      if (std::ranges::any_of(nodes_, [&](const ChartNode& node) { return node.name == full; })) return full;
      if (holder.empty()) return "";
    }
  }

  /// Returns the port of a transition; each has its own, so that arrows from different states do not merge.
  static std::string entry(const ChartNode& from, std::size_t transition) {
    return from.name + "." + std::to_string(transition + 1);
  }

  Json end(const std::string& state, const std::string& port) const {
    return Json::object().set("node", id_ + "." + state).set("port", port);
  }

  Json state(const ChartNode& node) const {
    Json inputs = Json::list(), outputs = Json::list(), lines = Json::list();
    for (const ChartNode& other : nodes_)
      for (std::size_t t = 0; t < other.to.size(); ++t)
        if (other.to[t].first == node.name && other.name != node.name)
          inputs.push(Json::object().set("port", entry(other, t)));
    for (std::size_t t = 0; t < node.to.size(); ++t) {
      if (node.to[t].first == node.name) continue;
      Json port = Json::object().set("port", "to." + std::to_string(t + 1));
      if (!node.to[t].second.empty()) port.set("label", node.to[t].second);
      outputs.push(std::move(port));
    }
    lines.push(node.name.substr(node.name.rfind('.') + 1));
    return Json::object()
        .set("id", id_ + "." + node.name)
        .set("name", "")
        .set("type", "state")
        .set("outline", "box")
        .set("lines", std::move(lines))
        .set("inputs", std::move(inputs))
        .set("outputs", std::move(outputs));
  }

  Json group(const ChartNode& node) const {
    Json members = Json::list();
    for (const ChartNode& other : nodes_)
      if (other.name == node.name || other.name.starts_with(node.name + "."))
        members.push(id_ + "." + other.name);
    return Json::object().set("name", node.name).set("members", std::move(members));
  }

  std::string id_;
  std::vector<ChartNode> nodes_;
};

}  // namespace

std::optional<Value> chart_of(const diagram::DiagramBlock& block) {
  const ParameterSpec* states = block.type().parameter("states");
  if (!states || states->kind != ParameterKind::tree) return std::nullopt;
  Value tree = states->get(block.block.get());
  return tree.map() ? std::optional(std::move(tree)) : std::nullopt;
}

json::Json chart_graph(const Value& states, const std::string& id) {
  return ChartWriter(states, id).graph();
}

}  // namespace stepwire::drawing
