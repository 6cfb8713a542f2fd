#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/analyse/statistics/within_subjects.hpp"
#include "engine/analyse/study/analysis.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/text/text_table.hpp"

namespace stepwire::study {

/// Names of the tables of conditions within subjects: intervals, comparisons, effect_sizes, power,
/// assumptions.
const std::vector<std::string>& comparison_table_names();

/// The one of that name; `of` stands behind its title, `seed` draws what power is simulated with.
text::TextTable comparison_table(const std::string& name, const statistics::WithinSubjects& within,
                                 const std::string& of, std::uint64_t seed);

/// Which assumptions hold, in words, and what to read where one does not.
text::TextTable assumptions_table(const statistics::WithinSubjects& within, const std::string& title);

/// All of them for programs; what does not exist is null. Without a seed there is no power.
json::Json comparisons_json(const statistics::WithinSubjects& within, std::optional<std::uint64_t> seed);

}  // namespace stepwire::study
