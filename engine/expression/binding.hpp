#pragma once

namespace stepwire {

/// How strongly the operators of the language bind, which is how those of C++ do; a power is a call there.
enum class Binding { open, condition, either, both, comparison, sum, product, prefix, power, atom };

}  // namespace stepwire
