#pragma once

#include <string>
#include <vector>

namespace stepwire {

/// A set of the Statistical Reference Datasets of NIST for nonlinear regression (public domain,
/// itl.nist.gov/div898/strd): data, starts, and certified values and standard errors.
struct NistSet {
  std::string name;
  std::vector<double> y;
  std::vector<std::vector<double>> x;  ///< [predictor][row]
  std::vector<double> starts[2], certified, errors;
  double squares = 0.0;  ///< sum of the residuals' squares
};

/// A set from the text of its file, or from the lines of parameters, of the residual sum of squares and of
/// data in it.
NistSet nist_set(const std::string& name, const std::string& text);

/// The small sets, whose numbers are in this source.
std::vector<NistSet> small_nist_sets();

/// All 27 sets from files such as nist_strd/Misra1a.dat below the folder STEPWIRE_DATA; none without them.
std::vector<NistSet> all_nist_sets();

/// A diagram that fits the model of a set from one of its starts (0, 1); `more` are further keys of `fit`.
std::string nist_diagram(const NistSet& set, std::size_t start, const std::string& more = "");

/// The number of significant digits in which a value agrees with a certified one, at most 11 of them.
double digits(double value, double certified);

}  // namespace stepwire
