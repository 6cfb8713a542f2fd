#include "engine/model/diagram/swept_values.hpp"

#include <fmt/format.h>

#include <utility>

namespace stepwire::diagram {

SweptValues::SweptValues(std::vector<std::string> texts, std::vector<yaml::Mark> marks,
                         std::vector<std::uint32_t> which)
    : texts_(std::move(texts)), marks_(std::move(marks)), which_(std::move(which)) {
  marks_.resize(texts_.size());
}

SweptValues::SweptValues(std::vector<double> numbers, const std::string& unit, const yaml::Mark& mark)
    : marks_{mark},
      numbers_(std::move(numbers)),
      unit_text_(unit),
      unit_(unit::parse_unit(unit).value_or(unit::Unit{})) {}

std::size_t SweptValues::size() const {
  if (!numbers_.empty()) return numbers_.size();
  return which_.empty() ? texts_.size() : which_.size();
}

std::string SweptValues::text(std::size_t value) const {
  if (!are_numbers()) return texts_[which(value)];
  return fmt::format("{}{}{}", numbers_[value], unit_text_.empty() ? "" : " ", unit_text_);
}

yaml::Mark SweptValues::mark(std::size_t value) const {
  return marks_[are_numbers() ? 0 : which(value)];
}

double SweptValues::number(std::size_t value) const {
  return unit_text_.empty() ? numbers_[value] : unit_.to_si(numbers_[value]);
}

std::optional<unit::Dimension> SweptValues::dimension() const {
  if (are_numbers()) return unit_text_.empty() ? std::nullopt : std::optional(unit_.dimension);
  for (const std::string& text : texts_)
    if (const auto quantity = unit::parse_quantity(text); quantity && quantity->dimension)
      return quantity->dimension;
  return std::nullopt;
}

}  // namespace stepwire::diagram
