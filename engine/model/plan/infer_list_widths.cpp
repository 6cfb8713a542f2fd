#include "engine/model/plan/infer_list_widths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <unordered_map>

#include "engine/base/text/count.hpp"
#include "engine/model/plan/port_sizes.hpp"
#include "engine/model/plan/worklist.hpp"

namespace stepwire::plan {

namespace {

/// Finds the open nodes that depend on no other open node. Of a strongly connected component without further
/// dependences it selects the first eligible node. `followings` has pairs of a node and one that it depends
/// on, in any order. The components are found by Tarjan's algorithm in linear time.
std::vector<int> ends_of_chains(const std::vector<bool>& open, const std::vector<bool>& may_be_chosen,
                                const std::vector<std::pair<int, int>>& followings) {
  const auto is_open = [&](int node) { return open[static_cast<std::size_t>(node)]; };
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> edges(open.size());
  for (const auto& [node, from] : followings)
    if (is_open(node) && is_open(from))
      boost::add_edge(static_cast<std::size_t>(node), static_cast<std::size_t>(from), edges);
  std::vector<std::size_t> component(open.size());
  const std::size_t count = boost::strong_components(edges, component.data());
  std::vector<bool> has_end(count, true);
  for (const auto& [node, from] : followings) {
    const std::size_t own = component[static_cast<std::size_t>(node)];
    if (is_open(node) && is_open(from) && own != component[static_cast<std::size_t>(from)])
      has_end[own] = false;
  }
  std::vector<int> chosen;
  for (std::size_t node = 0; node < open.size(); ++node) {
    if (!open[node] || !may_be_chosen[node] || !has_end[component[node]]) continue;
    has_end[component[node]] = false;
    chosen.push_back(static_cast<int>(node));
  }
  return chosen;
}

class ListWidthInference {
 public:
  ListWidthInference(Draft& draft, PortSizes& sizes, MatrixLists& matrices, const std::vector<int>& order)
      : draft_(draft), sizes_(sizes), matrices_(matrices) {
    for (const int block : order) add_lists(static_cast<std::size_t>(block));
  }

  std::set<std::pair<std::size_t, std::size_t>> run() {
    do settle_columns();
    while (settle_scalars());
    return std::move(refused_);
  }

 private:
  struct List {
    std::size_t block, input;
    bool settled = false;
  };

  void add_lists(std::size_t block) {
    const std::vector<InputSpec>& inputs = draft_.type(block).inputs;
    for (std::size_t input = 0; input < inputs.size(); ++input)
      if (inputs[input].list && !PortShape(inputs[input].shape).is_matrix) add_list(block, input);
  }

  void add_list(std::size_t block, std::size_t input) {
    const int list = static_cast<int>(lists_.size());
    lists_.push_back({block, input});
    turns_.call(list);
    for (const diagram::Source& source : draft_.diagram().blocks[block].inputs[input])
      if (source.block >= 0 && source.element.is_whole())
        watchers_.emplace(sizes_.root(sizes_.of_output(source)), list);
  }

  /// Sets an open size and queues the lists that have it as an element.
  void learn(int size, Eigen::Index value) {
    sizes_.set(size, value);
    const auto [first, last] = watchers_.equal_range(sizes_.root(size));
    for (auto watcher = first; watcher != last; ++watcher) turns_.call(watcher->second);
  }

  void take_turns() {
    take_list_turns();
    while (sizes_.multiply() || matrices_.add_up()) {  // a new size may affect any list
      for (std::size_t list = 0; list < lists_.size(); ++list)
        if (!lists_[list].settled) turns_.call(static_cast<int>(list));
      take_list_turns();
    }
  }

  void settle_columns() {
    do take_turns();
    while (sizes_.settle_columns());
  }

  void take_list_turns() {
    while (const auto turn = turns_.next()) {
      List& list = lists_[static_cast<std::size_t>(*turn)];
      list.settled = list.settled || settle(list.block, list.input);
    }
  }

  /// Determines the size of a list; false while too many sizes of its elements are unknown.
  bool settle(std::size_t index, std::size_t input) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    const bool total = block.type().inputs[input].shape.starts_with('+');
    Eigen::Index sum = 0, most = 1;
    bool open = false;
    for (const diagram::Source& source : block.inputs[input]) {
      const auto size = sizes_.value_of(source);
      open = open || !size;
      sum = std::min(sum + size.value_or(0), max_numbers + 1);
      most = std::max(most, size.value_or(1));
    }
    if (open && (total || most == 1)) return false;
    const int own = sizes_.of_list(index, input);
    const auto known = sizes_.value(own);
    const Eigen::Index size = total ? sum : std::max(most, known.value_or(1));
    if (!known) learn(own, size);
    if (known && *known != size) refuse(index, input, size, *known);
    if (!total && size > 1) take_shape(own, size, block.inputs[input]);
    return true;
  }

  /// Copies the shape of the elements; all matrices of a list have the same one.
  void take_shape(int own, Eigen::Index size, const std::vector<diagram::Source>& elements) {
    for (const diagram::Source& element : elements) {
      if (sizes_.value_of(element) != size) continue;
      const int given = sizes_.of_source(element);
      if (const auto matrix = sizes_.factors(given)) sizes_.set_factors(own, matrix->first, matrix->second);
    }
  }

  void refuse(std::size_t index, std::size_t input, Eigen::Index size, Eigen::Index fitting) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    refused_.insert({index, input});
    draft_.report.add({block.origin.scope, block.input_marks[input]},
                      block.name + "." + block.type().inputs[input].name,
                      fmt::format("has {}; {} would fit", text::counted(size, "element"), fitting));
  }

  /// Makes open sizes that depend on no other open size scalars. Returns false if no size is open.
  bool settle_scalars() {
    const auto all = followings();
    std::vector<bool> open(static_cast<std::size_t>(sizes_.count())), has_no_factors(open.size());
    for (int size = 0; size < sizes_.count(); ++size) {
      open[static_cast<std::size_t>(size)] = sizes_.root(size) == size && !sizes_.value(size);
      has_no_factors[static_cast<std::size_t>(size)] = !sizes_.factors(size);
    }
    const std::vector<int> chosen = ends_of_chains(open, has_no_factors, all);
    for (const int size : chosen) learn(size, 1);
    return !chosen.empty();
  }

  /// Returns pairs of a size and one that it depends on, both as union-find roots.
  std::vector<std::pair<int, int>> followings() {
    std::vector<std::pair<int, int>> all = matrices_.sums();
    for (const List& list : lists_)
      if (!list.settled) add_followings(list, all);
    for (int size = 0; size < sizes_.count(); ++size)
      if (const auto matrix = sizes_.factors(size))
        all.emplace_back(size, matrix->first), all.emplace_back(size, matrix->second);
    for (auto& [size, from] : all) size = sizes_.root(size), from = sizes_.root(from);
    return all;
  }

  void add_followings(const List& list, std::vector<std::pair<int, int>>& all) {
    const int own = sizes_.of_list(list.block, list.input);
    for (const diagram::Source& element : draft_.diagram().blocks[list.block].inputs[list.input])
      if (!sizes_.value_of(element)) all.emplace_back(own, sizes_.of_source(element));
    if (const auto matrix = sizes_.factors(own))
      all.emplace_back(matrix->first, own), all.emplace_back(matrix->second, own);
  }

  Draft& draft_;
  PortSizes& sizes_;
  MatrixLists& matrices_;
  std::vector<List> lists_;
  std::unordered_multimap<int, int> watchers_;  ///< lists by the union-find root of an element's size
  Worklist turns_;                              ///< indices of lists
  std::set<std::pair<std::size_t, std::size_t>> refused_;
};

}  // namespace

std::set<std::pair<std::size_t, std::size_t>> infer_list_widths(Draft& draft, PortSizes& sizes,
                                                                MatrixLists& matrices,
                                                                const std::vector<int>& order) {
  return ListWidthInference(draft, sizes, matrices, order).run();
}

}  // namespace stepwire::plan
