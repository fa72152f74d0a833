#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace talus::sweep {

/// Programs of others that can run the members of a sweep.
enum class Engine : std::uint8_t { gnu_parallel, slurm, snakemake };

/// What a script must know of a sweep.
struct ScriptFacts {
  std::string name;  ///< of the sweep: letters, digits, - and _
  std::size_t n_members;
  std::string program;  ///< path of talus, absolute; the environment's TALUS wins over it
  std::string folder;   ///< of the sweep, absolute
};

struct Script {
  std::string file;  ///< its name, in the folder of the sweep
  std::string text;
  bool executable;
  std::string start;  ///< how to start it, for a shell
};

/// A script by which the engine runs each member as `talus member DIR N`. Paths stand in it as literals of its language.
Script script_for(Engine engine, const ScriptFacts& facts);

/// A text as one word of a POSIX shell, whatever it holds.
std::string shell_quoted(std::string_view text);

}  // namespace talus::sweep
