#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/statistics/observations.hpp"

namespace stepwire::statistics {

/// A main effect (one factor) or an interaction (several).
struct Term {
  std::vector<std::string> factors;
  /// The term whose mean square it is compared with; empty: the residual. In a design within subjects that is
  /// the interaction of the term with the subject.
  std::vector<std::string> against{};

  /// "haptic:visual".
  std::string name() const;
};

/// One term for each factor: the form of the thesis' tables 4 and 6.
std::vector<Term> additive_terms(const std::vector<std::string>& factors);

/// Every factor and every interaction of them, main effects first.
std::vector<Term> crossed_terms(const std::vector<std::string>& factors);

/// What a sum of squares tells of a term. In balanced data all three are the same; without interactions the
/// last two are.
/// - sequential (type I): beyond the terms before it;
/// - hierarchical (type II): beyond all terms that do not contain it;
/// - partial (type III): beyond all other terms, factors coded so that their levels sum to zero.
enum class SumsOfSquares { sequential, hierarchical, partial };

/// Departure from sphericity of a term within subjects of more than one degree of freedom.
struct Sphericity {
  double epsilon = 1.0;      ///< Greenhouse and Geisser 1959: 1 where it holds, 1/df at the worst
  double p_corrected = 1.0;  ///< of F with both degrees of freedom times epsilon
  double huynh_feldt =
      1.0;  ///< epsilon of Huynh and Feldt 1976, which corrects less; nan for too few subjects
  double p_huynh_feldt = 1.0;  ///< of F with both degrees of freedom times that; nan with it
  double mauchly = 1.0;        ///< Mauchly's W; nan where there are too few subjects
  double p_mauchly = 1.0;      ///< of sphericity; nan with W
};

/// One line of an analysis of variance. What does not exist is nan.
struct AnovaRow {
  std::string name;
  double freedom = 0.0;
  double sum_of_squares = 0.0;
  double mean_square = 0.0;
  double f = 0.0, p = 0.0;
  double partial_eta_squared = 0.0;  ///< SS / (SS + SS of what it is compared with)
  std::string against;               ///< the line that F compares with; empty for the lines without F
  std::optional<Sphericity> sphericity{};
};

/// An analysis of variance, with what a reader must know of it.
struct Anova {
  std::string response;
  std::vector<AnovaRow> terms;
  AnovaRow residual, total;
  SumsOfSquares sums = SumsOfSquares::partial;
  bool balanced = true;               ///< every combination of levels was observed, all equally often
  std::string design;                 ///< in words: "40 values in 4 cells of 10"
  std::vector<std::string> warnings;  ///< terms that cannot be estimated, variances that differ, ...

  /// The line of a term, or nullptr where there is none.
  const AnovaRow* find(const std::string& name) const;
};

/// Fits the terms by least squares. A term that the data cannot tell from those before it is left without
/// degrees of freedom, and a warning says which they are. Throws StatisticsError for what Observations::check
/// refuses, for unknown factors, and for a term `against` which is not there.
Anova anova(const Observations& observations, const std::vector<Term>& terms,
            SumsOfSquares sums = SumsOfSquares::partial);

/// "type III (beyond all other terms)".
std::string words_of(SumsOfSquares sums);

}  // namespace stepwire::statistics
