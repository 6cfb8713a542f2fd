#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/statistics/observations.hpp"

namespace stepwire::statistics {

/// A main effect (one factor) or an interaction (several).
struct Term {
  std::vector<std::string> factors;
  /// Error term: F is the ratio to its mean square. Empty: the residual. In a within-subject design it is the
  /// interaction of the term with the subject.
  std::vector<std::string> against{};

  /// Returns "haptic:visual".
  std::string name() const;
};

/// Returns one term per factor: the form of the thesis' tables 4 and 6.
std::vector<Term> additive_terms(const std::vector<std::string>& factors);

/// Returns every factor and every interaction of them, main effects first.
std::vector<Term> crossed_terms(const std::vector<std::string>& factors);

/// Definition of a term's sum of squares. In balanced data all three are equal; without interactions the last
/// two are.
enum class SumsOfSquares {
  sequential,    ///< Type I: beyond the terms before it.
  hierarchical,  ///< Type II: beyond all terms that do not contain it.
  partial        ///< Type III: beyond all other terms, factors coded so that their levels sum to zero.
};

/// Departure from sphericity of a within-subject term of more than one degree of freedom.
struct Sphericity {
  double epsilon = 1.0;      ///< Greenhouse and Geisser 1959: 1 under sphericity, 1/df at worst.
  double p_corrected = 1.0;  ///< P of F with both degrees of freedom times epsilon.
  double huynh_feldt =
      1.0;  ///< Epsilon of Huynh and Feldt 1976, a weaker correction; nan for too few subjects.
  double p_huynh_feldt = 1.0;  ///< P of F with both degrees of freedom times huynh_feldt; nan with it.
  double mauchly = 1.0;        ///< Mauchly's W; nan for too few subjects.
  double p_mauchly = 1.0;      ///< P of Mauchly's test; nan with W.
};

/// One line of an analysis of variance. Missing values are nan.
struct AnovaRow {
  std::string name;
  double freedom = 0.0;
  double sum_of_squares = 0.0;
  double mean_square = 0.0;
  double f = 0.0, p = 0.0;
  double partial_eta_squared = 0.0;  ///< SS / (SS + SS of the error term).
  std::string against;               ///< Name of the error term of F; empty in lines without F.
  std::optional<Sphericity> sphericity{};
};

/// An analysis of variance, with the warnings that a report must show.
struct Anova {
  std::string response;
  std::vector<AnovaRow> terms;
  AnovaRow residual, total;
  SumsOfSquares sums = SumsOfSquares::partial;
  bool balanced = true;  ///< True if every combination of levels was observed, all equally often.
  std::string design;    ///< Description of the design: "40 values in 4 cells of 10".
  std::vector<std::string> warnings;  ///< Terms that cannot be estimated, unequal variances, ...

  /// Returns the line of a term; nullptr if there is none.
  const AnovaRow* find(const std::string& name) const;
};

/// Fits the terms by least squares. A term that is collinear with earlier ones has no degrees of freedom; a
/// warning names those. Throws StatisticsError for the faults of Observations::check, for unknown factors,
/// and for a missing term in `against`.
Anova anova(const Observations& observations, const std::vector<Term>& terms,
            SumsOfSquares sums = SumsOfSquares::partial);

/// Returns "type III (beyond all other terms)".
std::string words_of(SumsOfSquares sums);

/// Observations in groups with the same levels of all factors of a model. The model sees one row per group,
/// so its cost does not grow with the number of observations. The values are differences from the first one,
/// which keep the digits that a large mean would cost.
struct Grouped {
  Observations groups;    ///< One row per observed combination of levels; the values are the means.
  Eigen::VectorXd roots;  ///< Roots of the numbers of observations.
  double within = 0.0;    ///< Sum of squares about the means.
  double total = 0.0;     ///< Sum of squares about the mean of all.
  double count = 0.0;     ///< Number of observations.
};

/// Returns a sum of squares, or 0 if it is only the rounding error of scores whose squares sum to `all`.
double beyond_rounding(double sum, double all);

/// Returns a line without F.
AnovaRow anova_row(const std::string& name, double freedom, double sum);

/// Sets F, P and partial eta squared of a line against an error term. They remain nan if either has no
/// degrees of freedom or the error does not vary.
void judge(AnovaRow& row, const AnovaRow& error);

/// Adds a warning that names the terms without F because their error does not vary.
void warn_of_missing_f(Anova& result);

/// Set the description of the design, and add a warning if the variances of its cells differ.
void describe_design(Anova& result, const Observations& observations, const std::vector<std::string>& names);
void warn_of_variances(Anova& result, const Observations& observations,
                       const std::vector<std::string>& names);

}  // namespace stepwire::statistics
