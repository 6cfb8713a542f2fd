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

/// Sizes as nodes of a graph. A pair of `followings` is a node and one that it depends on.
struct SizeGraph {
  std::vector<bool> open;
  std::vector<bool> plain;        ///< follows its elements, and neither a sum nor a product
  std::vector<bool> factor_free;  ///< is not the size of a matrix
  std::vector<std::pair<int, int>> followings;
};

/// Finds open nodes of a graph that become scalars, by its strongly connected components (Tarjan).
///
/// A component of plain nodes becomes scalar as a whole if everything that it depends on is scalar, because
/// the largest of scalars is a scalar. In any other component without further dependences the first node
/// becomes a scalar; the others follow by propagation.
class ScalarChoice {
 public:
  explicit ScalarChoice(const SizeGraph& graph) : graph_(graph), component_(graph.open.size()) {
    boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> edges(graph.open.size());
    for (const auto& [node, from] : graph.followings)
      if (graph.open[index(node)] && graph.open[index(from)])
        boost::add_edge(index(node), index(from), edges);
    const std::size_t count = boost::strong_components(edges, component_.data());
    whole_.assign(count, true);
    is_end_.assign(count, true);
    judge_components();
  }

  std::vector<int> nodes() {
    std::vector<int> chosen;
    for (std::size_t node = 0; node < graph_.open.size(); ++node)
      if (graph_.open[node] && takes(node)) chosen.push_back(static_cast<int>(node));
    return chosen;
  }

 private:
  static std::size_t index(int node) { return static_cast<std::size_t>(node); }

  /// Goes through the dependences between components in the order of the components: Tarjan's algorithm
  /// numbers a component after all that it depends on.
  void judge_components() {
    for (std::size_t node = 0; node < graph_.open.size(); ++node)
      if (graph_.open[node] && !graph_.plain[node]) whole_[component_[node]] = false;
    std::vector<std::pair<std::size_t, std::size_t>> between;
    for (const auto& [node, from] : graph_.followings)
      if (graph_.open[index(node)] && graph_.open[index(from)] &&
          component_[index(node)] != component_[index(from)])
        between.emplace_back(component_[index(node)], component_[index(from)]);
    std::sort(between.begin(), between.end());
    for (const auto& [own, from] : between) {
      whole_[own] = whole_[own] && whole_[from];
      is_end_[own] = false;
    }
  }

  /// True if a node becomes a scalar: each of a whole component, the first one of any other.
  bool takes(std::size_t node) {
    const std::size_t own = component_[node];
    if (whole_[own]) return true;
    if (!is_end_[own] || !graph_.factor_free[node]) return false;
    is_end_[own] = false;
    return true;
  }

  const SizeGraph& graph_;
  std::vector<std::size_t> component_;
  std::vector<bool> whole_, is_end_;
};

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

  /// Makes open sizes that depend on scalars alone scalars, too. Returns false if no size is open.
  bool settle_scalars() {
    const std::vector<int> chosen = ScalarChoice(size_graph()).nodes();
    for (const int size : chosen) learn(size, 1);
    return !chosen.empty();
  }

  SizeGraph size_graph() {
    SizeGraph graph;
    graph.followings = followings();
    graph.plain.assign(static_cast<std::size_t>(sizes_.count()), true);
    for (const int size : sums_and_products())
      graph.plain[static_cast<std::size_t>(sizes_.root(size))] = false;
    for (int size = 0; size < sizes_.count(); ++size) {
      graph.open.push_back(sizes_.root(size) == size && !sizes_.value(size));
      graph.factor_free.push_back(!sizes_.factors(size));
    }
    return graph;
  }

  /// Returns the sizes that are sums or belong to a product.
  std::vector<int> sums_and_products() {
    std::vector<int> all;
    for (const auto& [sum, element] : matrices_.sums()) all.insert(all.end(), {sum, element});
    for (const List& list : lists_)
      if (draft_.type(list.block).inputs[list.input].shape.starts_with('+'))
        all.push_back(sizes_.of_list(list.block, list.input));
    for (int size = 0; size < sizes_.count(); ++size)
      if (const auto matrix = sizes_.factors(size))
        all.insert(all.end(), {size, matrix->first, matrix->second});
    return all;
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
