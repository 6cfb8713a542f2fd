#pragma once

#include "engine/analyse/estimation/search_items.hpp"

namespace stepwire::estimation {

/// Searches from many starts: a few steps of each, and on from those that are best by then.
class Searches {
 public:
  /// Searches from a start, as the part `done` to `done + share` of all.
  using Descend =
      std::function<Minimum(const SearchStart& start, double done, double share, const std::string& what)>;

  /// `workers` search in place of `descend` where they are not null.
  Searches(const FitRequest& request, const std::atomic<bool>* interrupt, messages::ItemWorkers* workers,
           Descend descend)
      : request_(request), interrupt_(interrupt), workers_(workers), descend_(std::move(descend)) {}

  /// Where each of them came to; of an interrupted call one at least.
  std::vector<Minimum> from(const std::vector<Eigen::VectorXd>& starts) const;

 private:
  std::vector<Minimum> first_looks(const std::vector<Eigen::VectorXd>& starts) const;
  void follow(std::vector<Minimum>& minima) const;
  template <class NameOf>
  std::vector<Minimum> search(const std::vector<SearchStart>& starts, double done, double share,
                              const NameOf& name_of) const;

  const FitRequest& request_;
  const std::atomic<bool>* interrupt_;
  messages::ItemWorkers* workers_;
  Descend descend_;
};

/// The minima by rising cost, as their indices; equal ones in their order.
std::vector<std::size_t> ranking(const std::vector<Minimum>& minima);

}  // namespace stepwire::estimation
