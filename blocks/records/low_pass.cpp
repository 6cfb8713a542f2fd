#include <fmt/format.h>

#include "blocks/records/butterworth.hpp"
#include "blocks/records/steps.hpp"

namespace stepwire {

namespace {

constexpr int usual_order = 4, highest_order = 12;

}  // namespace

void low_pass(Record& record, const StepOptions& given) {
  const double frequency = given.positive("low_pass", unit::Dimension{} / time_dimension);
  const int order =
      given.has("order") ? static_cast<int>(given.whole("order", 1, highest_order)) : usual_order;
  given.require_rows(record, rows_beyond_ends(order) + 1, fmt::format("order {}", order));
  given.require_even(record);
  const double cutoff = frequency * record.interval();
  if (!(cutoff < 0.5))
    given.refuse("low_pass", fmt::format("{} is not below half of the rows' rate, {} Hz in {}",
                                         given.text("low_pass"), 0.5 / record.interval(), record.file));
  const auto sections = butterworth(order, cutoff);
  for (RecordColumn& column : record.columns)
    column.values = forward_and_backward(sections, order, column.values);
}

}  // namespace stepwire
