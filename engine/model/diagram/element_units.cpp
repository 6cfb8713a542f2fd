#include "engine/model/diagram/element_units.hpp"

#include <algorithm>
#include <utility>

namespace stepwire::diagram {
namespace {

using Unit = std::optional<unit::Dimension>;

bool are_alike(const Unit& a, const Unit& b) {
  if (!a || !b) return !a && !b;
  return *a == *b && a->angle == b->angle && a->cycles == b->cycles;
}

}  // namespace

ElementUnits::ElementUnits(Each each) : each_(std::move(each)) {
  const bool alike =
      std::ranges::all_of(each_, [&](const Unit& one) { return are_alike(one, each_.front()); });
  if (alike && each_.size() > 1) each_.resize(1);
  if (each_.empty()) each_.emplace_back();
}

std::optional<unit::Dimension> ElementUnits::of(std::size_t element) const {
  if (is_one()) return each_.front();
  return element < each_.size() ? each_[element] : std::nullopt;
}

ElementUnits ElementUnits::elements(const ElementRange& range) const {
  if (is_one() || range.is_whole()) return *this;
  if (!range.known || range.first + range.count > each_.size()) return unknown();
  const auto first = each_.begin() + static_cast<std::ptrdiff_t>(range.first);
  return ElementUnits(Each(first, first + static_cast<std::ptrdiff_t>(range.count)));
}

ElementUnits ElementUnits::times(const ElementUnits& other, double exponent) const {
  if (!is_one() && !other.is_one() && each_.size() != other.each_.size()) return unknown();
  Each product(std::max(each_.size(), other.each_.size()));
  for (std::size_t k = 0; k < product.size(); ++k) {
    const Unit a = of(k), b = other.of(k);
    if (a && b) product[k] = *a * unit::power(*b, exponent);
  }
  return ElementUnits(std::move(product));
}

std::optional<unit::Dimension> ElementUnits::other_than_one() const {
  for (const Unit& unit : each_)
    if (unit && *unit != unit::Dimension{}) return unit;
  return std::nullopt;
}

bool agree(const ElementUnits& a, const ElementUnits& b) {
  return !a.times(b, -1.0).other_than_one();
}

}  // namespace stepwire::diagram
