#include "linear/condensed_solver.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/both.hpp"
#include "core/sums.hpp"

namespace talus::linear {
namespace {

/// Rows among which single precision looks for pivots. Where that is not enough, double precision looks everywhere.
constexpr Index near = 64;

}  // namespace

CondensedSolver::CondensedSolver(const SparsePattern& matrix, std::size_t least_for_single)
    : CheckedSolver(matrix), number_(matrix.n(), -1), least_for_single_(least_for_single) {
  const Index n = matrix.n();
  const auto starts = matrix.column_starts();
  const auto rows = matrix.rows();
  std::vector<Index> length(n, 0);
  for (const Index row : rows) ++length[row];
  std::vector<bool> is_link(n, false);
  for (Index j = 0; j < n; ++j) is_link[j] = length[j] <= longest_row && matrix.find(j, j) >= 0;
  // A candidate whose row meets another candidate's column, other than that of the candidate just before it, is no link.
  Index previous = -1;
  std::vector<Index> before(n, -1);
  for (Index j = 0; j < n; ++j)
    if (is_link[j]) before[j] = std::exchange(previous, j);
  for (Index j = 0; j < n; ++j)
    for (Index k = starts[j]; is_link[j] && k < starts[j + 1]; ++k)
      if (is_link[rows[k]] && rows[k] != j && before[rows[k]] != j) is_link[rows[k]] = false;
  for (Index j = 0; j < n; ++j) {
    if (is_link[j]) continue;
    number_[j] = static_cast<Index>(kept_.size());
    kept_.push_back(j);
  }

  std::vector<Index> link_of(n, -1);
  for (Index j = 0; j < n; ++j) {
    if (!is_link[j]) continue;
    link_of[j] = static_cast<Index>(links_.size());
    links_.push_back({j, matrix.find(j, j), -1, -1, {}, {}});
    if (before[j] < 0 || !is_link[before[j]]) continue;
    const Index below = matrix.find(j, before[j]);
    if (below < 0) continue;
    links_.back().before = below;
    links_[link_of[before[j]]].after = below;
  }
  std::vector<std::vector<Entry>> row(links_.size()), column(links_.size());
  for (Index j = 0; j < n; ++j)
    for (Index k = starts[j]; k < starts[j + 1]; ++k) {
      const Index i = rows[k];
      if (is_link[i] && !is_link[j]) row[link_of[i]].push_back(entry(number_[j], k));
      if (!is_link[i] && is_link[j]) column[link_of[j]].push_back(entry(number_[i], k));
    }
  for (const auto& entries : row) row_entries_.insert(row_entries_.end(), entries.begin(), entries.end());
  for (const auto& entries : column) column_entries_.insert(column_entries_.end(), entries.begin(), entries.end());
  const Entry *next_row = row_entries_.data(), *next_column = column_entries_.data();
  for (std::size_t l = 0; l < links_.size(); ++l) {
    links_[l].row = {std::exchange(next_row, next_row + row[l].size()), row[l].size()};
    links_[l].column = {std::exchange(next_column, next_column + column[l].size()), column[l].size()};
  }

  find_halves();

  // The band after condensation: direct entries, and those through the chains.
  for_each_kept_entry([&](Index i, Index j) { width_ = std::max(width_, std::abs(i - j)); });
  single_ = TwoEndedBand<float>(n_kept(), width_, near);
  double_ = TwoEndedBand<double>(n_kept(), width_, width_);
  for_each_kept_entry([&](Index i, Index j) {
    single_.expect(i, j);
    double_.expect(i, j);
  });
  for (Index j = 0; j < n_kept(); ++j)
    for (Index k = starts[kept_[j]]; k < starts[kept_[j] + 1]; ++k)
      if (const Index i = number_[rows[k]]; i >= 0)
        direct_.push_back({k, rows[k], single_.slot(i, j), double_.slot(i, j)});
  scratch_.resize(kept_.size());
  scratch_single_.resize(kept_.size());
}

/// Chains at both ends that meet no kept number of each other's half.
void CondensedSolver::find_halves() {
  const Index half = n_kept() / 2;
  const auto within = [](const Link& link, Index first, Index last) {
    const auto inside = [&](const Entry& e) { return e.number >= first && e.number < last; };
    return std::ranges::all_of(link.row, inside) && std::ranges::all_of(link.column, inside);
  };
  left_links_ = right_links_ = 0;
  std::size_t l = 0;
  for (; l < links_.size() && within(links_[l], 0, half); ++l)
    if (links_[l].after < 0) left_links_ = l + 1;
  for (l = links_.size(); l > left_links_ && within(links_[l - 1], half, n_kept()); --l)
    if (links_[l - 1].before < 0) right_links_ = links_.size() - (l - 1);
}

template <class Visit>
void CondensedSolver::for_each_kept_entry(const Visit& visit) const {
  const auto starts = pattern().column_starts();
  const auto rows = pattern().rows();
  for (Index j = 0; j < n_kept(); ++j)
    for (Index k = starts[kept_[j]]; k < starts[kept_[j] + 1]; ++k)
      if (number_[rows[k]] >= 0) visit(number_[rows[k]], j);
  Index least = n_kept(), most = -1;  // kept rows that see this link or one above it
  for (std::size_t l = links_.size(); l-- > 0;) {
    const Link& link = links_[l];
    if (link.after < 0) least = n_kept(), most = -1;
    for (const Entry& e : link.column) least = std::min<Index>(least, e.number), most = std::max<Index>(most, e.number);
    for (const Entry& e : link.row)
      for (Index i = least; i <= most; ++i) visit(i, e.number);
  }
}

double CondensedSolver::flops_bound() const {
  const auto w = static_cast<double>(width());
  return 4.0 * static_cast<double>(n_kept()) * w * w;
}

void CondensedSolver::factor_anew() {
  in_single_ = allows_single() && !rejected();
  if (in_single_) {
    try {
      condense(single_);
    } catch (const SingularMatrix&) { in_single_ = false; }
  }
  if (!in_single_) condense(double_);
  record(n_kept() * (3 * width() + 1), flops_bound());
}

void CondensedSolver::gather() {
  row_values_.clear();
  for (const Entry& e : row_entries_) row_values_.push_back(values()[e.position]);
  column_values_.clear();
  for (const Entry& e : column_entries_) column_values_.push_back(values()[e.position] * row_scale()[kept_[e.number]]);
  pivots_.clear();
  for (const Link& link : links_)
    pivots_.push_back({1.0 / values()[link.diagonal], link.before >= 0 ? values()[link.before] : 0.0});
}

template <class Part>
void CondensedSolver::in_parts(const Part& part) const {
  const std::size_t right = links_.size() - right_links_;
  core::both(
      left_links_ > 0, [&] { part(0, left_links_); }, [&] { part(right, links_.size()); });
  part(left_links_, right);
}

template <class Real>
void CondensedSolver::condense(TwoEndedBand<Real>& band) {
  band.clear();
  constexpr bool in_single = sizeof(Real) == sizeof(float);
  core::in_halves(direct_.size(), [&](std::size_t begin, std::size_t end) {
    for (const Direct& entry : std::span(direct_).subspan(begin, end - begin))  // each in a place of its own
      band.add(in_single ? entry.single : entry.whole, values()[entry.position] * row_scale()[entry.row]);
  });
  gather();

  std::vector<Real> seen(kept_.size(), Real(0));
  in_parts([&](std::size_t first, std::size_t last) { condense_links(band, first, last, seen); });
  band.factor();
}

/// Chain by chain from the top: `seen`, zero at first, is the column of C E^-1 for a link, over the kept rows [least, most].
template <class Real>
void CondensedSolver::condense_links(TwoEndedBand<Real>& band, std::size_t first, std::size_t last,
                                     std::vector<Real>& seen) const {
  Index least = n_kept(), most = -1;
  for (std::size_t l = last; l-- > first;) {
    const Link& link = links_[l];
    if (link.after < 0) {
      if (most >= least) std::fill(seen.begin() + least, seen.begin() + most + 1, Real(0));
      least = n_kept();
      most = -1;
    }
    const double diagonal = values()[link.diagonal];
    if (diagonal == 0.0) throw SingularMatrix("a chain row has a vanishing diagonal", link.unknown);
    const auto carry = static_cast<Real>(link.after < 0 ? 0.0 : -values()[link.after] / diagonal);
    for (Index i = least; i <= most; ++i) seen[i] *= carry;
    auto value = column_values_.begin() + (link.column.data() - column_entries_.data());
    for (const Entry& e : link.column) {
      seen[e.number] += static_cast<Real>(*value++ / diagonal);
      least = std::min<Index>(least, e.number);
      most = std::max<Index>(most, e.number);
    }
    if (most < least) continue;
    const std::span<const Real> part(seen.data() + least, static_cast<std::size_t>(most - least + 1));
    for (const Entry& e : link.row) band.add_column(e.number, least, static_cast<Real>(-values()[e.position]), part);
  }
  if (most >= least) std::fill(seen.begin() + least, seen.begin() + most + 1, Real(0));
}

void CondensedSolver::take_out(std::size_t first, std::size_t last, std::span<const double> b) {
  if (first == last) return;
  double below = 0.0;
  auto of_entry = column_values_.begin() + (links_[first].column.data() - column_entries_.data());
  for (std::size_t l = first; l < last; ++l) {
    const Link& link = links_[l];
    below = (b[link.unknown] - pivots_[l].before * below) * pivots_[l].inverse;
    for (const Entry& e : link.column) scratch_[e.number] -= *of_entry++ * below;
  }
}

void CondensedSolver::put_back(std::size_t first, std::size_t last, std::span<double> b) const {
  if (first == last) return;
  double below = 0.0;
  auto of_entry = row_values_.begin() + (links_[first].row.data() - row_entries_.data());
  for (std::size_t l = first; l < last; ++l) {
    const Link& link = links_[l];
    double value = b[link.unknown];
    for (const Entry& e : link.row) value -= *of_entry++ * scratch_[e.number];
    below = (value - pivots_[l].before * below) * pivots_[l].inverse;
    b[link.unknown] = below;
  }
}

void CondensedSolver::substitute(std::span<double> b) {
  const auto of_kept = [this](const auto& act) {
    core::in_halves(kept_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) act(k);
    });
  };
  of_kept([&](std::size_t k) { scratch_[k] = b[kept_[k]] * row_scale()[kept_[k]]; });
  in_parts([&](std::size_t first, std::size_t last) { take_out(first, last, b); });
  if (in_single_) {
    of_kept([&](std::size_t k) { scratch_single_[k] = static_cast<float>(scratch_[k]); });
    single_.solve(scratch_single_);
    of_kept([&](std::size_t k) { scratch_[k] = scratch_single_[k]; });
  } else {
    double_.solve(scratch_);
  }
  in_parts([&](std::size_t first, std::size_t last) { put_back(first, last, b); });
  of_kept([&](std::size_t k) { b[kept_[k]] = scratch_[k]; });
}

std::string CondensedSolver::describe() const {
  std::ostringstream line;
  line << "condensed band LU (LAPACK, two-ended, in " << (in_single_ ? "single" : "double")
       << " precision): " << links_.size() << " unknowns solved for along chains, " << n_kept() << " left, " << width()
       << " diagonals on either side, " << memory() / (1 << 20) << " MiB";
  if (statistics().factorisations > 0) line << ", residual " << statistics().first_residual;
  return line.str();
}

}  // namespace talus::linear
