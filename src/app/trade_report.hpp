#pragma once

#include <string>

#include "app/trade_study.hpp"
#include "output/table_file.hpp"

namespace talus::app {

/// What people read: a row a choice, what was left out, and what to choose for which accuracy.
[[nodiscard]] std::string text_of(const TradeStudy& study);

/// "For 1 % of heap_angle: ...", one line an accuracy.
[[nodiscard]] std::string advice_of(const TradeStudy& study);

/// A row a choice, with all costs and errors.
[[nodiscard]] std::string csv_of(const TradeStudy& study);

/// Fronts, advice and what was left out, for programs.
[[nodiscard]] std::string json_text_of(const TradeStudy& study);

/// Adds to a sweep's table along its dimension `choice`: groups, words, errors, the front; and `number` with the reference's own uncertainty.
void add_to(output::Table& table, const TradeStudy& study);

}  // namespace talus::app
