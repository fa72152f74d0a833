#include "sweep/engines.hpp"

#include <algorithm>
#include <cctype>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace talus::sweep {
namespace {

/// Slurm's own default allows no larger array than 1001.
constexpr std::size_t most_tasks = 1000;

constexpr std::string_view parallel_text =
    R"script(#!/usr/bin/env bash
# shellcheck disable=SC2016  # what stands in single quotes is not to be expanded here
# Sweep @NAME@: runs the members that are not finished with GNU parallel, and each that fails once more. Arguments go to parallel,
# for example --jobs 4. parallel.log tells of each member; started again, the script goes on with what that log lacks.
set -euo pipefail
export TALUS=${TALUS:-@PROGRAM@}
export PARALLEL_SHELL=/bin/sh
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"
seq 0 @LAST@ | parallel --joblog parallel.log --resume-failed --retries 2 --termseq TERM,60000,KILL,1000 --line-buffer --tag "$@" \
  '"$TALUS" member . {}'
)script";

constexpr std::string_view slurm_text =
    R"script(#!/usr/bin/env bash
# shellcheck disable=SC2016  # what stands in single quotes is not to be expanded here
# Sweep @NAME@ as a job array: sbatch run_slurm.sh. Options given to sbatch win over those below. Two minutes before the time limit
# Slurm sends TERM to this script, which passes it on: the member writes a checkpoint and ends with code 75, and the task is
# queued again, to go on from there.
#SBATCH --job-name=@NAME@
#SBATCH --array=0-@LAST_TASK@
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --signal=B:TERM@120
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=/dev/null
set -uo pipefail
export TALUS=${TALUS:-@PROGRAM@}
cd -- @FOLDER@ || exit 3
mkdir -p logs
exec >>"logs/task_$SLURM_ARRAY_TASK_ID.log" 2>&1

child='' stopped=''
trap 'stopped=1; [ -z "$child" ] || kill -TERM "$child" 2>/dev/null' TERM INT

# Runs one member and sets `code` to its exit code. A signal ends a wait early, hence the loop. A member that has just been started
# cannot answer one yet: 143, and nothing is lost.
run_member() {
  "$TALUS" member . "$1" &
  child=$!
  code=0
  wait "$child" || code=$?
  while kill -0 "$child" 2>/dev/null; do
    code=0
    wait "$child" || code=$?
  done
  child=''
  [ -z "$stopped" ] || [ "$code" -ne 143 ] || code=75
}

failed=0
for ((member = SLURM_ARRAY_TASK_ID; member < @N@; member += @TASKS@)); do
  for attempt in 1 2; do
    [ -z "$stopped" ] || code=75
    [ -n "$stopped" ] || run_member "$member"
    if [ "$code" -eq 75 ]; then
      scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
      exit 75
    fi
    [ "$code" -ne 0 ] || continue 2
    [ -z "$stopped" ] || exit "$code"
    echo "member $member: attempt $attempt ended with code $code"
  done
  failed=9
done
exit "$failed"
)script";

constexpr std::string_view snakemake_text =
    R"script(# Sweep @NAME@ with Snakemake: runs the members that are not finished, and each that fails once more.
import os

workdir: workflow.basedir

TALUS = os.environ.get("TALUS", @PROGRAM@)

rule all:
    input: expand("done/{member}", member=range(@N@))

rule member:
    output: touch("done/{member}")
    wildcard_constraints: member=r"\d+"
    threads: 1
    retries: 1
    shell: "{TALUS:q} member . {wildcards.member}"
)script";

std::string filled(std::string_view pattern, const std::vector<std::pair<std::string, std::string>>& words) {
  std::string out;
  while (!pattern.empty()) {
    const auto word = std::ranges::find_if(words, [&](const auto& w) { return pattern.starts_with(w.first); });
    out += word == words.end() ? std::string(1, pattern.front()) : word->second;
    pattern.remove_prefix(word == words.end() ? 1 : word->first.size());
  }
  return out;
}

/// A text as an expression of Python, whatever bytes it holds.
std::string python_quoted(std::string_view text) {
  std::ostringstream out;
  out << "os.fsdecode(b'" << std::hex << std::setfill('0');
  for (const char c : text) {
    const bool plain =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view(" /._-").find(c) != std::string_view::npos;
    if (plain) out << c;
    else out << "\\x" << std::setw(2) << static_cast<unsigned>(static_cast<unsigned char>(c));
  }
  out << "')";
  return out.str();
}

}  // namespace

std::string shell_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

Script script_for(Engine engine, const ScriptFacts& facts) {
  const std::size_t tasks = std::min(facts.n_members, most_tasks);
  const auto quoted = [&](const std::string& text) {
    return engine == Engine::snakemake ? python_quoted(text) : shell_quoted(text);
  };
  const auto text = [&](std::string_view pattern) {
    return filled(pattern, {{"@NAME@", facts.name},
                            {"@PROGRAM@", quoted(facts.program)},
                            {"@FOLDER@", quoted(facts.folder)},
                            {"@LAST@", std::to_string(facts.n_members - 1)},
                            {"@LAST_TASK@", std::to_string(tasks - 1)},
                            {"@TASKS@", std::to_string(tasks)},
                            {"@N@", std::to_string(facts.n_members)}});
  };
  const std::string folder = facts.folder + "/";
  switch (engine) {
    case Engine::gnu_parallel:
      return {"run_parallel.sh", text(parallel_text), true, shell_quoted(folder + "run_parallel.sh")};
    case Engine::slurm:
      return {"run_slurm.sh", text(slurm_text), true, "sbatch " + shell_quoted(folder + "run_slurm.sh")};
    case Engine::snakemake:
      return {"Snakefile", text(snakemake_text), false,
              "snakemake --cores all --keep-going --snakefile " + shell_quoted(folder + "Snakefile")};
  }
  throw std::logic_error("no such engine");
}

}  // namespace talus::sweep
