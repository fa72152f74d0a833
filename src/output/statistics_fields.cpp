#include "output/statistics_fields.hpp"

#include <array>
#include <functional>

namespace talus::output {

namespace {

struct Entry {
  const char* name;
  const char* unit;
  const char* long_name;
  double (*value)(const core::Statistics&);
};

template <auto Member>
double read(const core::Statistics& s) {
  return static_cast<double>(std::invoke(Member, s));
}

using S = core::Statistics;
constexpr std::array entries{
    Entry{"n_steps", "1", "accepted steps", read<&S::steps>},
    Entry{"n_error_test_failures", "1", "steps rejected by the error test", read<&S::error_test_failures>},
    Entry{"n_newton_failures", "1", "steps on which Newton's method did not converge", read<&S::newton_failures>},
    Entry{"n_newton_iterations", "1", "Newton iterations", read<&S::newton_iterations>},
    Entry{"n_residuals", "1", "evaluations of the residual", read<&S::residuals>},
    Entry{"n_jacobians", "1", "evaluations of the Jacobian", read<&S::jacobians>},
    Entry{"n_factorisations", "1", "factorisations of the Jacobian", read<&S::factorisations>},
    Entry{"n_solves", "1", "solves with a factorised Jacobian", read<&S::solves>},
    Entry{"n_inadmissible_states", "1", "residual evaluations refused by the model", read<&S::inadmissible_states>},
    Entry{"n_restarts", "1", "starts afresh at breakpoints and checkpoints, or continuation steps of steady solves",
          read<&S::restarts>},
    Entry{"order", "1", "order of the last step", read<&S::order>},
    Entry{"last_step", "s", "size of the last step", read<&S::last_step>},
    Entry{"cpu_residual", "s", "CPU time in residuals", read<&S::seconds_residual>},
    Entry{"cpu_jacobian", "s", "CPU time in Jacobians", read<&S::seconds_jacobian>},
    Entry{"cpu_factor", "s", "CPU time in factorisations", read<&S::seconds_factor>},
    Entry{"cpu_solve", "s", "CPU time in linear solves", read<&S::seconds_solve>},
};

}  // namespace

std::vector<core::Variable> StatisticsFields::variables() const {
  std::vector<core::Variable> all;
  for (const Entry& e : entries) all.push_back({e.name, {}, e.unit, e.long_name, core::Storage::double_precision});
  return all;
}

void StatisticsFields::evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) {
  values.resize(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) values[i].assign(1, entries[i].value(snapshot.statistics));
}

}  // namespace talus::output
