#pragma once

// Elementary functions of a kernel, with the bits that runs on the processor have.
//
// A device has neither libsleef nor a C library. These are the scalar algorithms of SLEEF 3.5.1, with the
// same coefficients and the same order of operations, and without fused multiply-add. Source:
// src/libm/sleefsimddp.c and dd.h, Copyright Naoki Shibata and contributors 2010-2020, Boost Software
// License 1.0. Each function is defined under the symbol that elementary.hpp declares, so blocks call
// fn::sin() here as well.
//
// The results have the bits of libsleef, with one exception: sin, cos and tan of angles beyond 1e14 differ by
// two units in the last place at most. SLEEF's table for them is replaced by a product of integers (Payne and
// Hanek: Radian reduction for trigonometric functions, 1983).
//
// Included by the text of kernels, after engine/base/math/elementary.hpp.

#include "engine/base/math/elementary.hpp"
#include "engine/simulate/device/exponential.hpp"
#include "engine/simulate/device/trigonometric.hpp"

// Define a function under the symbol that elementary.hpp declares. The text of a kernel has one of these
// lines for each function that it may call, since a device would compile all others, too.
#define STEPWIRE_KERNEL_OF_ONE(name, error)                                                   \
  extern "C" double stepwire_##name(double x) noexcept __asm__(STEPWIRE_SYMBOL(name, error)); \
  extern "C" double stepwire_##name(double x) noexcept {                                      \
    return stepwire::device::name(x);                                                         \
  }
#define STEPWIRE_KERNEL_OF_TWO(name, error)                                                             \
  extern "C" double stepwire_##name(double x, double y) noexcept __asm__(STEPWIRE_SYMBOL(name, error)); \
  extern "C" double stepwire_##name(double x, double y) noexcept {                                      \
    return stepwire::device::name(x, y);                                                                \
  }
