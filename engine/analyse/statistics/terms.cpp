#include <algorithm>
#include <cstdint>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

std::vector<Term> additive_terms(const std::vector<std::string>& factors) {
  std::vector<Term> terms;
  for (const std::string& factor : factors) terms.push_back({{factor}, {}});
  return terms;
}

std::vector<Term> crossed_terms(const std::vector<std::string>& factors) {
  std::vector<Term> terms;
  for (std::uint64_t chosen = 1; chosen < std::uint64_t{1} << factors.size(); ++chosen) {
    Term term;
    for (std::size_t i = 0; i < factors.size(); ++i)
      if ((chosen >> i & 1U) != 0) term.factors.push_back(factors[i]);
    terms.push_back(std::move(term));
  }
  std::stable_sort(terms.begin(), terms.end(),
                   [](const Term& a, const Term& b) { return a.factors.size() < b.factors.size(); });
  return terms;
}

}  // namespace stepwire::statistics
