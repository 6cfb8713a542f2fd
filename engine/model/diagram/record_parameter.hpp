#pragma once

#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

class Report;

/// Records a parameter, written `$name`, under a name: as the output of a block with its value.
void record_parameter(const yaml::Node& node, const std::string& name, const Scope& scope,
                      RecordRequest& request, Report& report);

}  // namespace stepwire::diagram
