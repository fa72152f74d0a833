#include "linear/mumps_factors.hpp"

#include <dmumps_c.h>
#include <smumps_c.h>

#include <cstdint>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "linear/ordering.hpp"

namespace talus::linear {
namespace {

// MUMPS' jobs, and places (from one on, as in its manual) in its arrays of controls and of answers.
constexpr int start = -1, end = -2, analyse = 1, factorise = 2, substitute_job = 3;
constexpr int error_unit = 1, message_unit = 2, statistics_unit = 3, verbosity = 4, transversal = 6, ordering = 7,
              scaling = 8, spare_memory = 14;
constexpr int given = 1;

constexpr int workspace_too_small_for_integers = -8, workspace_too_small = -9, structurally_singular = -6,
              singular = -10, no_memory_left = -13, no_memory_left_inside = -7;

constexpr int least_spare = 50, most_spare = 6400;  // [%]

}  // namespace

template <class Real>
struct MumpsFactors<Real>::Library : std::conditional_t<std::is_same_v<Real, double>, DMUMPS_STRUC_C, SMUMPS_STRUC_C> {
  int& control(int place) { return this->icntl[place - 1]; }
  [[nodiscard]] int state() const { return this->infog[0]; }
};

template <class Real>
MumpsFactors<Real>::MumpsFactors(const SparsePattern& pattern, int spare)
    : values_(pattern.n_nonzeros()), library_(std::make_unique<Library>()) {
  if (pattern.n() > std::numeric_limits<int>::max()) throw std::invalid_argument("MumpsFactors: too many unknowns");
  for (Index j = 0; j < pattern.n(); ++j)
    for (Index k = pattern.column_starts()[j]; k < pattern.column_starts()[j + 1]; ++k) {
      rows_.push_back(static_cast<int>(pattern.rows()[k]) + 1);
      columns_.push_back(static_cast<int>(j) + 1);
    }
  for (const Index place : inverse(nested_dissection(pattern))) places_.push_back(static_cast<int>(place) + 1);
  constexpr int no_communicator = -987654;  // by MUMPS' manual, for the library without MPI
  library_->par = 1;
  library_->sym = 0;
  library_->comm_fortran = no_communicator;
  call(start);
  for (const int unit : {error_unit, message_unit, statistics_unit}) library_->control(unit) = -1;
  library_->control(verbosity) = 0;
  library_->control(transversal) = 0;
  library_->control(ordering) = given;
  library_->control(scaling) = 0;
  library_->control(spare_memory) = least_spare;
  library_->n = static_cast<int>(pattern.n());
  library_->nnz = pattern.n_nonzeros();
  library_->irn = rows_.data();
  library_->jcn = columns_.data();
  library_->a = values_.data();
  library_->perm_in = places_.data();
  call(analyse);
  reserve(spare);
}

/// Workspace for the real numbers, `spare` per cent beyond what was foreseen; what it holds is lost.
template <class Real>
void MumpsFactors<Real>::reserve(int spare) {
  constexpr int foreseen = 8;  // in millions where negative
  constexpr std::int64_t million = 1000000;
  const std::int64_t entries = library_->info[foreseen - 1];
  const std::int64_t all = (entries < 0 ? -million * entries : entries) * (100 + spare) / 100;
  const bool fits = all <= std::numeric_limits<int>::max();
  workspace_.reset();
  library_->lwk_user = static_cast<int>(fits ? all : -(all + million - 1) / million);
  workspace_ = std::make_unique_for_overwrite<Real[]>(fits ? all : -million * library_->lwk_user);
  library_->wk_user = workspace_.get();
}

template <class Real>
MumpsFactors<Real>::~MumpsFactors() {
  library_->job = end;
  if constexpr (std::is_same_v<Real, double>) dmumps_c(library_.get());
  else smumps_c(library_.get());
}

template <class Real>
void MumpsFactors<Real>::call(int job) {
  library_->job = job;
  if constexpr (std::is_same_v<Real, double>) dmumps_c(library_.get());
  else smumps_c(library_.get());
  const int state = library_->state();
  if (state >= 0 || state == workspace_too_small || state == workspace_too_small_for_integers) return;
  if (state == no_memory_left || state == no_memory_left_inside) throw std::bad_alloc();
  if (state == singular || state == structurally_singular) throw SingularMatrix("MUMPS: the matrix is singular", -1);
  throw SingularMatrix("MUMPS: no factors, status " + std::to_string(state), -1);
}

template <class Real>
void MumpsFactors<Real>::factor() {
  call(factorise);
  for (int& spare = library_->control(spare_memory); library_->state() < 0; call(factorise)) {
    if (spare >= most_spare) throw SingularMatrix("MUMPS: too many pivots are too small", -1);
    spare *= 2;
    reserve(spare);
  }
}

template <class Real>
void MumpsFactors<Real>::substitute(std::span<Real> b) {
  library_->nrhs = 1;
  library_->lrhs = library_->n;
  library_->rhs = b.data();
  call(substitute_job);
}

template <class Real>
Index MumpsFactors<Real>::fill() const {
  constexpr int entries = 29;  // in millions where negative
  const Index n = library_->infog[entries - 1];
  return n < 0 ? -1000000 * n : n;
}

template <class Real>
double MumpsFactors<Real>::flops() const {
  constexpr int operations = 3;
  return library_->rinfog[operations - 1];
}

template class MumpsFactors<float>;
template class MumpsFactors<double>;

}  // namespace talus::linear
