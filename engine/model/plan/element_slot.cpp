#include "engine/model/plan/element_slot.hpp"

#include <fmt/format.h>

namespace stepwire::plan {

SignalSlot element_slot(const SignalSlot& whole, const diagram::ElementIndex& element) {
  if (element.is_whole()) return whole;
  const Eigen::Index column = element.column == 0 ? 0 : element.column - 1;
  return {whole.offset + static_cast<std::size_t>(column * whole.rows() + element.row - 1)};
}

SignalSlot constant_slot(const diagram::Source& constant) {
  return element_slot({0, constant.constant.size(), constant.columns}, constant.element);
}

std::string missing_element(const diagram::ElementIndex& element, const SignalSlot& whole,
                            const std::string& name) {
  if (element.is_whole()) return "";
  if (element.column == 0 && whole.columns > 1)
    return fmt::format(
        "there is no '{}'; the signal is a {} matrix, of which an element has a row and a "
        "column, as in '.2.1'",
        name, shape_text(whole.size, whole.columns));
  if (element.row <= whole.rows() && element.column <= whole.columns) return "";
  return fmt::format("there is no '{}'; the signal has {} elements", name,
                     shape_text(whole.size, whole.columns));
}

std::string element_name(const std::string& signal, const SignalSlot& whole, Eigen::Index k) {
  if (whole.size == 1) return signal;
  if (whole.columns == 1) return fmt::format("{}.{}", signal, k + 1);
  return fmt::format("{}.{}.{}", signal, k % whole.rows() + 1, k / whole.rows() + 1);
}

diagram::SignalRef element_of(const diagram::SignalRef& signal, const SignalSlot& slot, Eigen::Index k) {
  diagram::SignalRef element = signal;
  if (slot.size > 1) element.element = {k % slot.rows() + 1, slot.columns > 1 ? k / slot.rows() + 1 : 0};
  return element;
}

std::string shape_text(Eigen::Index size, Eigen::Index columns) {
  return columns == 1 ? fmt::format("{}", size) : fmt::format("{} x {}", size / columns, columns);
}

}  // namespace stepwire::plan
