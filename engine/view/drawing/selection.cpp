#include "engine/view/drawing/selection.hpp"

#include <algorithm>

namespace stepwire::drawing {

bool follows_pattern(const std::string& name, const std::string& pattern) {
  // Greedy matching: only the last star needs to be extended, since another length of an earlier star cannot
  // match better.
  std::size_t at = 0, in_pattern = 0, star = std::string::npos, resumed = 0;
  while (at < name.size()) {
    if (in_pattern < pattern.size() && pattern[in_pattern] == '*') {
      star = in_pattern++;
      resumed = at;
    } else if (in_pattern < pattern.size() && pattern[in_pattern] == name[at]) {
      ++in_pattern;
      ++at;
    } else if (star != std::string::npos) {
      in_pattern = star + 1;
      at = ++resumed;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', in_pattern) == std::string::npos;
}

Selection::Selection(const diagram::Diagram& diagram, const Hierarchy& hierarchy, const GraphOptions& options)
    : diagram_(diagram), options_(options), above_(scope_prefix(hierarchy).size()) {
  for (const diagram::RecordRequest& request : diagram.records)
    for (const diagram::RecordedSignal& recorded : request.signals) add_recorded(recorded.signal);
  for (const diagram::DiagramOutput& output : diagram.outputs) add_recorded(output.signal);
}

std::string Selection::name_in(const Hierarchy& hierarchy, const std::string& name) const {
  return scope_prefix(hierarchy).substr(above_) + name;
}

bool Selection::hides(const std::string& name) const {
  return std::ranges::any_of(options_.hide,
                             [&](const auto& pattern) { return follows_pattern(name, pattern); });
}

bool Selection::hides(const Hierarchy& hierarchy, const WireSource& source) const {
  const auto port = static_cast<std::size_t>(source.port);
  if (source.child < 0) {
    if (!hierarchy.parent) return false;
    for (const ReferenceInput& input :
         hierarchy.parent->children[static_cast<std::size_t>(hierarchy.place)].inputs)
      if (input.name == hierarchy.inputs[port])
        return input.feeds.front().source && hides(*hierarchy.parent, *input.feeds.front().source);
    return false;
  }
  const BlockReference& from = hierarchy.children[static_cast<std::size_t>(source.child)];
  const std::string name = name_in(hierarchy, from.name);
  if (hides(name) || hides(name + "." + from.outputs[port])) return true;
  const auto inner =
      from.part && !from.is_active(source.port) ? from.part->output_sources[port] : std::nullopt;
  return inner && inner->child >= 0 && hides(*from.part, *inner);
}

bool Selection::is_recorded(const Hierarchy& hierarchy, const WireSource& source) const {
  const auto signal = hierarchy.signal(source);
  return signal && recorded_.contains({signal->block, signal->output});
}

bool Selection::is_open(const std::string& name, int depth) const {
  return depth < options_.depth || std::ranges::any_of(options_.open, [&](const auto& open) {
           return open == name || open.starts_with(name + ".");
         });
}

bool Selection::feeds_hidden_only(const Hierarchy& part, const std::string& input) const {
  bool feeds_any = false;
  const auto is_source = [&](const std::optional<WireSource>& source) {
    return source && source->child < 0 && part.inputs[static_cast<std::size_t>(source->port)] == input;
  };
  const auto is_input = [&](const WireFeed& feed) { return is_source(feed.source); };
  if (std::ranges::any_of(part.output_sources, is_source)) return false;
  for (const BlockReference& child : part.children)
    for (const ReferenceInput& one : child.inputs) {
      if (std::ranges::none_of(one.feeds, is_input)) continue;
      if (!hides_child(part, child)) return false;
      feeds_any = true;
    }
  return feeds_any;
}

std::vector<Selection::Feed> Selection::feeds(const Hierarchy& hierarchy, const BlockReference& child,
                                              int depth) const {
  const bool opened = child.part && is_open(name_in(hierarchy, child.name), depth);
  std::vector<Feed> found;
  for (const ReferenceInput& input : child.inputs) {
    if (opened && feeds_hidden_only(*child.part, input.name)) continue;
    for (std::size_t i = 0; i < input.feeds.size(); ++i)
      if (!input.feeds[i].source || !hides(hierarchy, *input.feeds[i].source)) found.push_back({&input, i});
  }
  return found;
}

std::vector<int> Selection::own_outputs(const Hierarchy& hierarchy) const {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(hierarchy.outputs.size()); ++i) {
    const auto& source = hierarchy.output_sources[static_cast<std::size_t>(i)];
    const bool hidden = hides(name_in(hierarchy, hierarchy.outputs[static_cast<std::size_t>(i)]));
    if (!hidden && !(source && hides(hierarchy, *source))) found.push_back(i);
  }
  return found;
}

/// Returns the outputs with a visible sink. If none has one, returns all outputs of its own that are not
/// hidden.
std::vector<int> Selection::outputs_of(const Hierarchy& hierarchy, int child,
                                       const std::set<std::pair<int, int>>& used) const {
  const BlockReference& from = hierarchy.children[static_cast<std::size_t>(child)];
  const int count = static_cast<int>(from.outputs.size());
  std::vector<int> some, all;
  for (int i = 0; i < count; ++i) {
    if (hides(hierarchy, WireSource{child, i})) continue;
    if (i < static_cast<int>(from.own_outputs)) all.push_back(i);
    if (used.contains({child, i}) || is_recorded(hierarchy, {child, i})) some.push_back(i);
  }
  return some.empty() ? all : some;
}

std::vector<Selection::Shown> Selection::shown(const Hierarchy& hierarchy,
                                               const std::vector<int>& own) const {
  std::set<std::pair<int, int>> used;
  for (const BlockReference& child : hierarchy.children)
    for (const ReferenceInput& input : child.inputs)
      for (const WireFeed& feed : input.feeds)
        if (feed.source && !hides_child(hierarchy, child))
          used.insert({feed.source->child, feed.source->port});
  for (const int output : own)
    if (const auto& source = hierarchy.output_sources[static_cast<std::size_t>(output)])
      used.insert({source->child, source->port});
  std::vector<Shown> shown;
  for (int child = 0; child < static_cast<int>(hierarchy.children.size()); ++child) {
    const bool hidden = hides_child(hierarchy, hierarchy.children[static_cast<std::size_t>(child)]);
    shown.push_back({hidden, hidden ? std::vector<int>{} : outputs_of(hierarchy, child, used)});
  }
  return shown;
}

}  // namespace stepwire::drawing
