#include "engine/model/plan/canonical_order.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string>
#include <tuple>

namespace stepwire::plan {

namespace {

constexpr std::size_t max_work = 2'000'000;  // blocks times rounds
constexpr std::size_t max_rounds = 32;

/// True where name `a` precedes `b`, with numbers compared by value ("mass_2" before "mass_10").
bool natural_less(const std::string& a, const std::string& b) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!digit(a[i]) || !digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    const std::size_t first_a = std::min(a.find_first_not_of('0', i), a.size()),
                      first_b = std::min(b.find_first_not_of('0', j), b.size());
    for (i = first_a; i < a.size() && digit(a[i]);) ++i;
    for (j = first_b; j < b.size() && digit(b[j]);) ++j;
    if (i - first_a != j - first_b) return i - first_a < j - first_b;
    if (const int order = a.compare(first_a, i - first_a, b, first_b, j - first_b)) return order < 0;
  }
  return std::tuple(a.size() - i, a) < std::tuple(b.size() - j, b);
}

/// Colour refinement (Weisfeiler and Leman 1968) with ranks as colours. Blocks begin with ranks by type. Each
/// round splits a rank by the ranks at the other ends of its wires, until no rank splits. A round costs a
/// sort of the wires. Large diagrams get few rounds; names order the remaining ties.
class Refinement {
 public:
  explicit Refinement(const Draft& draft)
      : draft_(draft), order_(draft.blocks.size()), rank_(draft.blocks.size()), wires_(draft.blocks.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    for (std::size_t b = 0; b < wires_.size(); ++b) add_wires(b);
  }

  std::vector<int> run() {
    std::vector<Key> keys(rank_.size());
    for (std::size_t b = 0; b < keys.size(); ++b) keys[b] = own_key(b);
    std::size_t count = rank_by([&](int a, int b) { return keys[at(a)] < keys[at(b)]; });
    const std::size_t rounds = std::min(max_rounds, max_work / std::max<std::size_t>(1, rank_.size()));
    for (std::size_t round = 0; round < rounds && count < rank_.size(); ++round) {
      const std::size_t before = count;
      count = refine();
      if (count == before) break;
    }
    std::ranges::sort(order_, [&](int a, int b) {
      if (rank_[at(a)] != rank_[at(b)]) return rank_[at(a)] < rank_[at(b)];
      return natural_less(name(a), name(b));
    });
    return std::move(order_);
  }

 private:
  /// Properties of a block alone, without parameter values.
  using Key = std::tuple<std::string_view, int, std::int64_t, std::int64_t, std::vector<Eigen::Index>,
                         std::vector<Eigen::Index>, std::vector<std::size_t>>;
  /// One end of a wire: its connection at both ends, and the block at the other end.
  struct Wire {
    std::tuple<int, std::size_t, std::size_t, int, Eigen::Index, Eigen::Index> how;
    int other;
  };

  static std::size_t at(int block) { return static_cast<std::size_t>(block); }
  const std::string& name(int block) const { return draft_.plan.diagram.blocks[at(block)].name; }

  Key own_key(std::size_t b) const {
    const diagram::DiagramBlock& block = draft_.plan.diagram.blocks[b];
    std::vector<std::size_t> connected;
    for (const auto& sources : block.inputs) connected.push_back(sources.size());
    const Rate& rate = draft_.plan.blocks[b].rate;
    return {block.type().name,   static_cast<int>(rate.kind),   rate.ticks,
            rate.first,          draft_.blocks[b].output_sizes, draft_.blocks[b].state_sizes,
            std::move(connected)};
  }

  void add_wires(std::size_t b) {
    const diagram::DiagramBlock& block = draft_.plan.diagram.blocks[b];
    const int self = static_cast<int>(b);
    if (block.guard >= 0) connect(self, block.guard, {0, 0, 0, 0, 0, 0});
    for (std::size_t i = 0; i < block.inputs.size(); ++i)
      for (std::size_t k = 0; k < block.inputs[i].size(); ++k) {
        const diagram::Source& source = block.inputs[i][k];
        if (source.block >= 0)
          connect(self, source.block, {1, i, k, source.output, source.element.row, source.element.column});
      }
  }
  void connect(int reader, int source, const decltype(Wire::how)& how) {
    wires_[at(reader)].push_back({how, source});
    auto back = how;
    std::get<0>(back) += 2;
    wires_[at(source)].push_back({back, reader});
  }

  /// Splits each rank once and returns the number of ranks.
  std::size_t refine() {
    for (std::vector<Wire>& wires : wires_)
      if (wires.size() > 1)
        std::ranges::sort(wires, [&](const Wire& a, const Wire& b) { return key(a) < key(b); });
    return rank_by([&](int a, int b) {
      if (rank_[at(a)] != rank_[at(b)]) return rank_[at(a)] < rank_[at(b)];
      return std::ranges::lexicographical_compare(
          wires_[at(a)], wires_[at(b)], [&](const Wire& x, const Wire& y) { return key(x) < key(y); });
    });
  }
  std::pair<decltype(Wire::how), std::size_t> key(const Wire& wire) const {
    return {wire.how, rank_[at(wire.other)]};
  }

  template <class Less>
  std::size_t rank_by(const Less& less) {
    std::ranges::sort(order_, less);
    std::vector<std::size_t> ranks(rank_.size());
    std::size_t rank = 0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (i > 0 && less(order_[i - 1], order_[i])) ++rank;
      ranks[at(order_[i])] = rank;
    }
    rank_ = std::move(ranks);
    return order_.empty() ? 0 : rank + 1;
  }

  const Draft& draft_;
  std::vector<int> order_;
  std::vector<std::size_t> rank_;         ///< rank of each block
  std::vector<std::vector<Wire>> wires_;  ///< wires of each block, as reader or source
};

}  // namespace

std::vector<int> canonical_order(const Draft& draft) {
  return Refinement(draft).run();
}

}  // namespace stepwire::plan
