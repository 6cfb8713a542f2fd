#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/comparison/compare.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::claim {

/// Baseline of the claim `like`: recorded signals that each run is compared with.
struct Likeness {
  std::string file;  ///< Name as written.
  std::vector<table::Table> tables{};
  comparison::Tolerances tolerances{};  ///< `only` has the compared signals.
  std::string within{}, jitter{};       ///< Texts of the tolerances as written.
};

/// Result of comparing runs with a baseline.
struct LikenessFound {
  double excess = 0.0;  ///< Largest difference divided by its tolerance; infinite for other lengths.
  std::string text{};   ///< Sentence about the worst signal.
  std::optional<std::size_t> run{};  ///< Index of the worst run.
  std::string fault{};               ///< Reason why the runs cannot be compared; empty if they can.
};

/// Reads the baseline that a claim names, from the folder of its diagram. Adds a fault and returns nullptr
/// for an unreadable file, for several runs, and for signals that the diagram does not record.
std::shared_ptr<Likeness> read_baseline(const yaml::Node& node, const query::NamesReading& read);

/// Sets a tolerance of the claim: "1 %" is relative, "0.1 N" absolute.
void read_likeness_within(Likeness& likeness, const yaml::Node& node, const query::NamesReading& read);
void read_likeness_jitter(Likeness& likeness, const yaml::Node& node, const query::NamesReading& read);
/// Restricts the comparison to named signals of the baseline.
void read_likeness_signals(Likeness& likeness, const yaml::Node& node, const query::NamesReading& read);

/// Adds faults of units and tolerances, which are known before the run.
void check_likeness(const Likeness& likeness, const yaml::Node& node, const query::NamesReading& read);

/// Returns the condition as text: "like baseline.csv within 1 % with jitter 2 ms".
std::string likeness_text(const Likeness& likeness);

/// Returns the recordings of one run.
std::vector<record::Recording> run_of(std::span<const record::Recording> recordings, std::size_t run);

/// Compares the runs of a piece with the baseline, and keeps the worst one. `first` is the index of its first
/// run.
void add_likeness(const Likeness& likeness, std::span<const record::Recording> runs, std::size_t first,
                  LikenessFound& found);

}  // namespace stepwire::claim
