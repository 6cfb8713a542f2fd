#include "engine/model/diagram/unit_faults.hpp"

#include <fmt/format.h>

#include "engine/base/unit/meaning.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/output_names.hpp"

namespace stepwire::diagram {

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
  std::string message =
      taken ? fmt::format("{} is in {}, but {} is in {}", equation.what, unit::si_name(*taken / wrong),
                          subject, unit::si_name(*taken))
            : fmt::format("{} does not fit: the units differ by {}", equation.what, unit::si_name(wrong));
  if (wrong == unit::Dimension{} && taken)
    message = fmt::format("{} {}; {} with a Gain", equation.what, unit::other_meaning(*taken / wrong, *taken),
                          unit::cure_of_rate(*taken / wrong, *taken));
  report_.add(equation.origin, subject, message);
}

void UnitFaults::add_element(const UnitEquation& equation, std::size_t element, const unit::Dimension& wrong,
                             const std::optional<unit::Dimension>& taken) {
  const std::string subject = subject_of(equation);
  const std::string message =
      taken
          ? fmt::format("element {} is in {}, but that of {} is in {}", element + 1,
                        unit::si_name(*taken / wrong), subject, unit::si_name(*taken))
          : fmt::format("element {} does not fit: the units differ by {}", element + 1, unit::si_name(wrong));
  report_.add(equation.origin, subject, message);
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
