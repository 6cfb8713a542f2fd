#include <cstdio>

#include <stepwire/stepwire.hpp>

namespace sw = stepwire;

int main() {
  const sw::Model model = sw::load("slide.yaml", {{"mass", "0.5 kg"}});
  sw::Simulation run(model);
  const sw::SignalId x = model.signal("slide.position");
  const sw::InputId push = model.input("push");
  run.set("spring.gain", -250.0);
  while (!run.finished()) {
    run.set(push, run.time() < 0.5 ? 10.0 : 0.0);
    run.step();
  }
  std::printf("%g m at %g s\n", run[x][0], run.time());

  const sw::Result result = sw::simulate(model);  // nothing pushes here: the file's default
  std::printf("%g m at the end\n", result["slide.position"].back());
}
