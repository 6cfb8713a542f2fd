#pragma once

#include "engine/analyse/estimation/search_items.hpp"

namespace stepwire::estimation {

/// Multi-start search: a few steps from each start, then full searches from the best ones.
class Searches {
 public:
  /// Function that searches from a start and reports its progress from `done` to `done + share`.
  using Descend =
      std::function<Minimum(const SearchStart& start, double done, double share, const std::string& what)>;

  /// With `workers`, unless nullptr, other processes search instead of `descend`.
  Searches(const FitRequest& request, const std::atomic<bool>* interrupt, messages::ItemWorkers* workers,
           Descend descend)
      : request_(request), interrupt_(interrupt), workers_(workers), descend_(std::move(descend)) {}

  /// Returns the end of each search; at least one after an interruption.
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

/// Returns the indices of the minima by rising cost; equal ones remain in order.
std::vector<std::size_t> ranking(const std::vector<Minimum>& minima);

}  // namespace stepwire::estimation
