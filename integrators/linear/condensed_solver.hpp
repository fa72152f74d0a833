#pragma once

#include <vector>

#include "linear/checked_solver.hpp"
#include "linear/two_ended_band.hpp"

namespace talus::linear {

/// For matrices of column-wise models: short rows that chain their diagonal unknown to the one before (incompressibility, cell
/// by cell up a column) are solved for that unknown exactly; what is left is a narrower band, factored by TwoEndedBand.
/// A row belongs to a chain if it has at most `longest_row` entries, one of them on its diagonal, and no entry in another
/// chain unknown but the one before it. The diagonal entries must not vanish.
class CondensedSolver final : public CheckedSolver {
 public:
  static constexpr Index longest_row = 8;

  explicit CondensedSolver(const SparsePattern& matrix);

  [[nodiscard]] std::string describe() const override;
  [[nodiscard]] std::string chosen() const override { return name; }
  static constexpr const char* name = "condensed";
  /// Unknowns that are left, and the diagonals on either side of the main one.
  [[nodiscard]] Index n_kept() const { return static_cast<Index>(kept_.size()); }
  [[nodiscard]] Index width() const { return band_.width(); }
  [[nodiscard]] double flops_bound() const;
  [[nodiscard]] std::size_t memory() const { return band_.memory(); }

 protected:
  void factor_anew() override;
  void substitute(std::span<double> b) override;

 private:
  struct Entry {
    Index number;    ///< kept number of the row (in columns) or of the column (in rows)
    Index position;  ///< in the value array
  };
  struct Link {
    Index unknown;              ///< row and column in the matrix
    Index diagonal;             ///< position of its diagonal entry
    Index before = -1;          ///< position of the entry in the column of the link before, -1 at the foot of a chain
    Index after = -1;           ///< position of the entry of the next link's row in this column
    std::vector<Entry> row;     ///< kept columns of its row
    std::vector<Entry> column;  ///< kept rows of its column
  };

  std::vector<Link> links_;    ///< chain after chain, each from its foot up
  std::vector<Index> kept_;    ///< unknown of each kept number
  std::vector<Index> number_;  ///< kept number of each unknown, -1 for links
  TwoEndedBand band_;
  std::vector<double> scratch_;
};

}  // namespace talus::linear
