#include "engine/simulate/codegen/guard_text.hpp"

#include <fmt/format.h>

namespace stepwire::codegen {

namespace {

std::string zero_text(const char* array, std::size_t first, std::size_t size) {
  if (size == 1) return fmt::format("  {}[{}] = 0.0;\n", array, first);
  return fmt::format("  for (int i = 0; i < {}; ++i) {}[{} + i] = 0.0;\n", size, array, first);
}

std::string active_of(const PlaceNames& names, const plan::PlannedGuard& guard) {
  return active_text(names, static_cast<std::ptrdiff_t>(guard.active));
}

}  // namespace

std::string copy_text(std::size_t from, std::size_t to, std::size_t size) {
  if (size == 1) return fmt::format("  w[{}] = w[{}];\n", to, from);
  return fmt::format("  for (int i = 0; i < {}; ++i) w[{} + i] = w[{} + i];\n", size, to, from);
}

std::string due_text(const plan::Period& period) {
  if (period.ticks == 1) return "";
  const std::string text = fmt::format("tick % {} == {}", period.ticks, period.first);
  return period.at_start ? fmt::format("(tick == 0 || {})", text) : text;
}

std::string active_text(const PlaceNames& names, std::ptrdiff_t active) {
  return active < 0 ? "" : fmt::format("w[{}]", names.at(static_cast<std::size_t>(active)));
}

std::string guard_call(const PlaceNames& names, const plan::Plan& plan, std::size_t guard,
                       const std::string& call) {
  const plan::PlannedGuard& of = plan.guards[guard];
  const std::string active = active_of(names, of);
  return fmt::format(
      "  {{\n  const bool was = {0} != 0.0;\n{1}  const bool is = {0} != 0.0;\n"
      "  if (was{2}) off_{4}(w);\n  if (is{3}) reset_{4}(w, numbers);\n  }}\n",
      active, call, of.once_per_edge ? "" : " && !is", of.once_per_edge ? "" : " && !was", guard);
}

std::string off_text(const PlaceNames& names, const plan::Plan& plan, std::size_t guard) {
  std::string text;
  for (const int inside : plan.guards[guard].inside) {
    const std::string active = active_of(names, plan.guards[static_cast<std::size_t>(inside)]);
    text += fmt::format("  if ({0} != 0.0) off_{1}(w);\n  {0} = 0.0;\n", active, inside);
  }
  for (const plan::Copied& piece : plan.guards[guard].keep)
    if (piece.from != plan::Layout::time) text += copy_text(piece.to, piece.from, piece.size);
  for (const plan::SignalSlot& slope : plan.guards[guard].slopes)
    text += zero_text("w", slope.offset, static_cast<std::size_t>(slope.size));
  return text;
}

std::string reset_text(const plan::PlannedGuard& guard) {
  std::string text;
  for (const plan::Copied& piece : guard.reset) text += copy_text(piece.from, piece.to, piece.size);
  return text;
}

std::string keep_text(const PlaceNames& names, const plan::Plan& plan) {
  std::string text;
  for (const plan::PlannedGuard& guard : plan.guards) {
    if (guard.keep.empty()) continue;
    text += fmt::format("  if ({} != 0.0) {{\n", active_of(names, guard));
    for (const plan::Copied& piece : guard.keep) text += copy_text(piece.from, piece.to, piece.size);
    text += "  }\n";
  }
  return text;
}

std::string zero_slopes_text(const plan::Plan& plan) {
  std::string text;
  for (const plan::PlannedGuard& guard : plan.guards)
    for (const plan::SignalSlot& slope : guard.slopes)
      text += zero_text("dot", slope.offset - plan.layout.derivatives, static_cast<std::size_t>(slope.size));
  return text;
}

}  // namespace stepwire::codegen
