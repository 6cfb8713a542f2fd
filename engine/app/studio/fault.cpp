#include "engine/app/studio/fault.hpp"

#include <new>

#include "engine/app/session/fault_json.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

Json fault_json(const std::string& whole, Json fault = Json::object()) {
  if (fault.find("faults")) return fault.set("text", whole);  // each of the faults has its own cure
  const yaml::Message split(whole);
  fault.set("text", split.wrong);
  if (!split.cure.empty()) fault.set("cure", split.cure);
  return fault;
}

}  // namespace

Json fault_in_flight() {
  try {
    throw;
  } catch (const Fault& fault) {
    return fault_json(fault.what(), fault.more());
  } catch (const yaml::Error& error) {
    Json fault = Json::object().set("text", error.what());
    return std::move(fault.set("faults", session::faults_json(error.faults())));
  } catch (const std::bad_alloc&) {
    return fault_json("there is not enough memory for this");
  } catch (const std::exception& error) {
    return fault_json(error.what());
  }
}

}  // namespace stepwire::studio
