#pragma once

namespace stepwire::unit {

/// The decimal that a double was most likely written as, to long double precision: 0.1 gives 0.1L.
long double as_decimal(double value);

/// The factor that a double stands for, where it is a published one: a decimal of up to 15 digits, such a
/// decimal over 9 or 3600 (degF, knot), or so many degrees in radians. Any other double as it is.
long double as_published(double value);

}  // namespace stepwire::unit
