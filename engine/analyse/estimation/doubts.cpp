#include "engine/analyse/estimation/doubts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/analyse/estimation/certainty.hpp"

namespace stepwire::estimation {

namespace {

constexpr double most_errors = 100.0;      // standard errors of a value
constexpr double least_agreement = 0.005;  // percent: printed as 0.00

void doubt_number(const FittedNumber& one, std::vector<std::string>& doubts) {
  if (one.at_bound || !(one.standard_error > most_errors * std::abs(one.value))) return;
  doubts.push_back(
      fmt::format("the standard error of {}, {:.2g}, is more than a hundred times its value, {:.2g}, so that "
                  "the records do "
                  "not decide it there; {}",
                  one.title(), one.standard_error, one.value, elsewhere));
}

void doubt_record(const FittedRecord& record, bool sought, std::vector<std::string>& doubts) {
  for (const ComparedRows& rows : record.comparisons) {
    if (!(rows.agreement < least_agreement)) continue;
    const std::string name = record.label.empty() ? "the record" : "the record " + record.label;
    doubts.push_back(fmt::format("{} is {} no better than by its mean (agreement {:.3g} %){}", name,
                                 record.held_out || !sought ? "predicted" : "described", rows.agreement,
                                 record.held_out || !sought ? "" : fmt::format("; {}", elsewhere)));
  }
}

void doubt_rows(const FitResult& result, std::vector<std::string>& doubts) {
  if (result.together == 0 || result.standard_errors == StandardErrors::serial) return;
  doubts.push_back(
      fmt::format("residuals go together over {} rows, and the standard errors count each row; where rows "
                  "follow each other "
                  "in time, 'standard_errors: serial' allows for it",
                  result.together));
}

}  // namespace

std::vector<std::string> doubts_of(const FitResult& result) {
  std::vector<std::string> doubts;
  for (const FittedNumber& one : result.numbers) doubt_number(one, doubts);
  for (const FittedRecord& record : result.records) doubt_record(record, !result.numbers.empty(), doubts);
  doubt_rows(result, doubts);
  return doubts;
}

}  // namespace stepwire::estimation
