#pragma once

namespace stepwire::unit {

/// Returns the decimal that a double was most likely written as, the shortest that reads back to it, in long
/// double precision: 0.1 gives 0.1L.
long double as_decimal(double value);

/// Returns the published conversion factor closest to a double. That is a decimal of up to 15 digits, such a
/// decimal over 9 or 3600 (degF, knot), or a number of degrees in radians. Any other double is returned
/// unchanged.
long double as_published(double value);

}  // namespace stepwire::unit
