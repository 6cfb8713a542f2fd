#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/analyse/statistics/within_subjects.hpp"
#include "engine/analyse/study/analysis.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/text/text_table.hpp"

namespace stepwire::study {

/// Returns the names of the tables on conditions within subjects: intervals, comparisons, effect_sizes,
/// power, assumptions.
const std::vector<std::string>& comparison_table_names();

/// Returns the table of a name. `of` is appended to its title; `seed` is that of simulated power.
text::TextTable comparison_table(const std::string& name, const statistics::WithinSubjects& within,
                                 const std::string& of, std::uint64_t seed);

/// Returns all tables as JSON; missing values are null. Without a seed there is no power.
json::Json comparisons_json(const statistics::WithinSubjects& within, std::optional<std::uint64_t> seed);

}  // namespace stepwire::study
