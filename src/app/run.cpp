#include "app/run.hpp"

#include <cstdio>

#include "app/memory.hpp"
#include "app/session.hpp"
#include "output/atomic_file.hpp"

namespace talus::app {

int run(const RunRequest& request) {
  const auto begun = std::chrono::steady_clock::now();
  Interrupt interrupt;
  const Scene scene = read_scene(request.scene_file, request.overrides);
  const Simulation simulation = build_within_memory(scene);
  const Theory theory = theory_of(scene);
  const RunFolder folder(request.out.value_or(std::filesystem::path("out") / scene.name),
                         request.force ? Claim::replace : Claim::fresh);
  for (const auto& warning : theory.warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  output::write_atomically(folder.scene(), scene.effective);
  return carry_out({scene, theory, simulation, folder, interrupt, request.command, begun});
}

}  // namespace talus::app
