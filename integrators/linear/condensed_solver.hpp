#pragma once

#include <span>
#include <vector>

#include "linear/checked_solver.hpp"
#include "linear/two_ended_band.hpp"

namespace talus::linear {

/// For matrices of column-wise models: short rows that chain their diagonal unknown to the one before (incompressibility, cell
/// by cell up a column) are solved for that unknown exactly; what is left is a narrower band, factored by TwoEndedBand.
/// A row belongs to a chain if it has at most `longest_row` entries, one of them on its diagonal, and no entry in another
/// chain unknown but the one before it. The diagonal entries must not vanish.
/// Where no more accuracy is asked for than `single_precision`, a band that is large in double precision is factored in single
/// precision, which halves its size and its time; a matrix that is singular then, or whose first solve fails, is factored in double.
class CondensedSolver final : public CheckedSolver {
 public:
  static constexpr Index longest_row = 8;

  static constexpr std::size_t large = 16 << 20;  ///< [bytes]: no cache holds it, solves are bound by memory

  /// Single precision from `least_for_single` bytes of the band on.
  explicit CondensedSolver(const SparsePattern& matrix, std::size_t least_for_single = large);

  [[nodiscard]] std::string describe() const override;
  [[nodiscard]] std::string chosen() const override { return name; }
  static constexpr const char* name = "condensed";
  /// Unknowns that are left, and the diagonals on either side of the main one.
  [[nodiscard]] Index n_kept() const { return static_cast<Index>(kept_.size()); }
  [[nodiscard]] Index width() const { return width_; }
  [[nodiscard]] double flops_bound() const;
  [[nodiscard]] std::size_t memory() const { return allows_single() ? single_.memory() : double_.memory(); }
  /// Whether single precision is tried.
  [[nodiscard]] bool allows_single() const {
    return accuracy() >= single_precision && double_.memory() >= least_for_single_;
  }

 protected:
  void factor_anew() override;
  void substitute(std::span<double> b) override;
  [[nodiscard]] bool coarse() const override { return in_single_; }

 private:
  struct Entry {
    std::int32_t number;    ///< kept number of the row (in columns) or of the column (in rows)
    std::int32_t position;  ///< in the value array
  };
  static Entry entry(Index number, Index position) {
    return {static_cast<std::int32_t>(number), static_cast<std::int32_t>(position)};
  }
  struct Link {
    Index unknown;               ///< row and column in the matrix
    Index diagonal;              ///< position of its diagonal entry
    Index before = -1;           ///< position of the entry in the column of the link before, -1 at the foot of a chain
    Index after = -1;            ///< position of the entry of the next link's row in this column
    std::span<const Entry> row;  ///< kept columns of its row
    std::span<const Entry> column;  ///< kept rows of its column
  };

  /// An entry that both matrices have, and where the band in single and that in double precision keep it.
  struct Direct {
    Index position, row, single, whole;
  };
  /// Of a link's row, with the values at hand.
  struct Pivot {
    double inverse, before;  ///< 1/diagonal; before: 0 at the foot of a chain
  };
  void gather();
  /// S = D - C E^-1 B of [E B; C D], E the chains, into `band`.
  template <class Real>
  void condense(TwoEndedBand<Real>& band);
  /// The part of links [first, last), whole chains.
  template <class Real>
  void condense_links(TwoEndedBand<Real>& band, std::size_t first, std::size_t last, std::vector<Real>& seen) const;
  void find_halves();
  /// The part of links [first, last) in a substitution: y = E^-1 b and kept rows less C y; x = E^-1 (b - B kept).
  void take_out(std::size_t first, std::size_t last, std::span<const double> b);
  void put_back(std::size_t first, std::size_t last, std::span<double> b) const;
  /// Calls part(first, last) for the links of both ends at once, then for those between.
  template <class Part>
  void in_parts(const Part& part) const;
  /// Calls visit(i, j) for each entry of S, some more than once.
  template <class Visit>
  void for_each_kept_entry(const Visit& visit) const;

  std::vector<Link> links_;                       ///< chain after chain, each from its foot up
  std::size_t left_links_ = 0, right_links_ = 0;  ///< first and last ones that two threads may condense at once
  std::vector<Index> kept_;                       ///< unknown of each kept number
  std::vector<Index> number_;                     ///< kept number of each unknown, -1 for links
  // In the order in which a solve goes through them: it is bound by memory.
  std::vector<Entry> row_entries_, column_entries_;  ///< the links', link after link
  std::vector<double> row_values_;                   ///< of those
  std::vector<double> column_values_;                ///< of those, rows scaled
  std::vector<Pivot> pivots_;                        ///< the links'
  std::size_t least_for_single_;
  Index width_ = 0;
  bool in_single_ = false;  ///< the precision of the factors at hand
  std::vector<Direct> direct_;
  TwoEndedBand<float> single_;
  TwoEndedBand<double> double_;
  std::vector<double> scratch_;
  std::vector<float> scratch_single_;
};

}  // namespace talus::linear
