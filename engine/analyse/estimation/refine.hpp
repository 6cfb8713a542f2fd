#pragma once

#include "engine/analyse/estimation/least_squares.hpp"

namespace stepwire::estimation {

/// A minimum after refine().
struct Refined {
  Minimum minimum;
  KnownPoint at;  ///< The point with central differences; without derivatives if these fail.
  double change = 0.0;  ///< Largest part of the last step, relative to a value or its standard error.
};

/// Refines the end of a search by Gauss-Newton steps with central differences. A search that compares costs
/// ends early: a thousandth of a standard error changes the cost by 1e-6 of one row's part. Refinement ends
/// when a step changes each unknown by at most `tolerance` of the larger of its value and its standard error.
/// It also ends when steps no longer become smaller. Unknowns at a bound towards which the cost falls are
/// held there.
Refined refine(const Residuals& residuals, const FitRequest& request, Minimum found,
               const std::atomic<bool>* interrupt);

}  // namespace stepwire::estimation
