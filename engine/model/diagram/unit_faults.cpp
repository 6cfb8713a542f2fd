#include "engine/model/diagram/unit_faults.hpp"

#include <fmt/format.h>

#include "engine/base/unit/meaning.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/output_names.hpp"

namespace stepwire::diagram {

/// Returns the cure for a source whose unit is not that of its port: of a number its unit, of a wire the unit
/// of a factor.
static std::string cure_of(const std::string& what, const unit::Dimension& factor,
                           const unit::Dimension& port) {
  if (what == "the number" || what == "the initial value")
    return fmt::format("write it in {}", unit::si_name(port));
  return fmt::format("connect a signal in {}, or put a Gain in {} between them", unit::si_name(port),
                     unit::si_name(factor));
}

/// Returns the message about two units of which only the ratio is known.
static yaml::Message ratio_message(const std::string& what, const std::string& port,
                                   const unit::Dimension& ratio) {
  const std::string by = unit::si_name(ratio);
  return {fmt::format("{} does not fit {}: {} is in {} times the unit of {}, and neither unit is known", what,
                      port, port, by, what),
          fmt::format("put a Gain of 1 {} between them, or write a unit at one of the two", by)};
}

const DiagramBlock& UnitFaults::block(int index) const {
  return report_.about().blocks[static_cast<std::size_t>(index)];
}

std::string UnitFaults::subject_of(const UnitEquation& equation) const {
  if (equation.block < 0) return equation.port;
  const DiagramBlock& owner = block(equation.block);
  if (equation.state < 0) return owner.name + "." + equation.port;
  return owner.name + "." +
         initial_key(owner.type(), owner.type().states[static_cast<std::size_t>(equation.state)]);
}

void UnitFaults::add(const UnitEquation& equation, const unit::Dimension& wrong,
                     const std::optional<unit::Dimension>& taken) {
  const std::string subject = subject_of(equation);
  if (!taken) return report_.add(equation.origin, subject, ratio_message(equation.what, subject, wrong));
  if (wrong == unit::Dimension{})
    return report_.add(
        equation.origin, subject,
        fmt::format("{} {}; {} with a Gain", equation.what, unit::other_meaning(*taken / wrong, *taken),
                    unit::cure_of_rate(*taken / wrong, *taken)));
  report_.add(equation.origin, subject,
              {fmt::format("{} is in {}, but {} is in {}", equation.what, unit::si_name(*taken / wrong),
                           subject, unit::si_name(*taken)),
               cure_of(equation.what, wrong, *taken)});
}

void UnitFaults::add_element(const UnitEquation& equation, std::size_t element, const unit::Dimension& wrong,
                             const std::optional<unit::Dimension>& taken) {
  const std::string subject = subject_of(equation);
  if (!taken)
    return report_.add(equation.origin, subject,
                       ratio_message(fmt::format("element {} of {}", element + 1, equation.what),
                                     fmt::format("that of {}", subject), wrong));
  report_.add(equation.origin, subject,
              fmt::format("element {} is in {}, but that of {} is in {}", element + 1,
                          unit::si_name(*taken / wrong), subject, unit::si_name(*taken)));
}

void UnitFaults::add_number(const UnitEquation& equation, const unit::Dimension& wrong,
                            const unit::Dimension& element) {
  const std::string subject = subject_of(equation);
  report_.add(equation.origin, subject,
              fmt::format("{} is in {}, but {} has an element in {}; write a list with a number for each "
                          "element",
                          equation.what, unit::si_name(element / wrong), subject, unit::si_name(element)));
}

std::optional<unit::Dimension> UnitFaults::demanded(const UnitEquation& equation) const {
  for (const UnitDemand& demand : report_.about().unit_demands)
    if (demand.port.c_str() == equation.port) return demand.dimension;
  return std::nullopt;
}

std::string UnitFaults::name_of(const Source& source) const {
  if (source.block < 0) return "the number";
  const DiagramBlock& owner = block(source.block);
  return output_name(owner.name, owner.type(), static_cast<std::size_t>(source.output));
}

}  // namespace stepwire::diagram
