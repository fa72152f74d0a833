#pragma once

#include <string>

#include "app/convergence_study.hpp"
#include "output/table_file.hpp"

namespace talus::app {

/// What people read: the levels, a row a number and a field with all its orders, and the verdict.
[[nodiscard]] std::string text_of(const ConvergenceStudy& study);

/// The verdict in words: one sentence, and what a finer grid would tell.
[[nodiscard]] std::string sentence_of(const ConvergenceStudy& study);

/// All of it, for programs.
[[nodiscard]] std::string json_text_of(const ConvergenceStudy& study);

/// Adds the orders, limits and differences to a sweep's table along its dimension `level`: variables along `number`, `field`,
/// `triple` of neighbouring levels and `step` from one level to the next.
void add_to(output::Table& table, const ConvergenceStudy& study);

}  // namespace talus::app
