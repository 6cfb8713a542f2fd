#pragma once

// Complete library in one header. README.md of this folder explains it.
#include <stepwire/blocks.hpp>
#include <stepwire/generate.hpp>
#include <stepwire/model.hpp>
#include <stepwire/observer.hpp>
#include <stepwire/simulate.hpp>
#include <stepwire/simulation.hpp>
