#include "linear/klu_solver.hpp"

#include <klu.h>

#include <algorithm>
#include <new>
#include <sstream>
#include <utility>

#include "linear/memory_limit.hpp"

namespace talus::linear {

static_assert(sizeof(SuiteSparse_long) == sizeof(Index));

/// Ordering and factors together with the settings they were made with.
struct KluSolver::Factors {
  std::string name;
  klu_l_common common{};
  klu_l_symbolic* symbolic = nullptr;
  klu_l_numeric* numeric = nullptr;

  explicit Factors(std::string ordering) : name(std::move(ordering)) { klu_l_defaults(&common); }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;
  ~Factors() {
    klu_l_free_numeric(&numeric, &common);
    klu_l_free_symbolic(&symbolic, &common);
  }
  [[nodiscard]] Index fill() const { return numeric->lnz + numeric->unz + numeric->nzoff; }
};

KluSolver::KluSolver(const SparsePattern& matrix, Settings settings)
    : CheckedSolver(matrix),
      settings_(std::move(settings)),
      starts_(matrix.column_starts().begin(), matrix.column_starts().end()),
      rows_(matrix.rows().begin(), matrix.rows().end()) {
  if (!settings_.ordering.empty() && static_cast<Index>(settings_.ordering.size()) != matrix.n()) {
    throw std::invalid_argument("KluSolver: the given ordering must name each unknown once");
  }
}

KluSolver::~KluSolver() = default;

std::unique_ptr<KluSolver::Factors> KluSolver::attempt(const std::string& name, Index max_fill) {
  auto factors = std::make_unique<Factors>(name);
  auto& common = factors->common;
  common.tol = settings_.pivot_tolerance;
  common.btf = name.find("btf") != std::string::npos ? 1 : 0;
  common.ordering = name.starts_with("AMD") ? 0 : 1;
  common.scale = 2;  // rows by their largest entry
  auto* starts = starts_.data();
  auto* rows = rows_.data();
  auto* given = settings_.ordering.data();
  factors->symbolic = name == "given" ? klu_l_analyze_given(pattern().n(), starts, rows, given, given, &common)
                                      : klu_l_analyze(pattern().n(), starts, rows, &common);
  if (common.status == KLU_OUT_OF_MEMORY) throw std::bad_alloc();
  if (factors->symbolic == nullptr) return nullptr;
  // Block triangular form with one block that is nearly all of the matrix only permutes it.
  if (common.btf != 0 && factors->symbolic->maxblock > pattern().n() * 9 / 10) return nullptr;
  if (max_fill > 0 && factors->symbolic->lnz + factors->symbolic->unz > static_cast<double>(max_fill)) return nullptr;
  {
    const MemoryLimit limit(bytes_an_entry * static_cast<std::size_t>(max_fill));
    if (max_fill > 0)
      common.initmem = 1.0;  // KLU begins with room for this many times the entries of the matrix, unlimited
    factors->numeric = klu_l_factor(starts, rows, const_cast<double*>(values().data()), factors->symbolic, &common);
    if (common.status == KLU_OUT_OF_MEMORY && !MemoryLimit::refused()) throw std::bad_alloc();
  }
  if (factors->numeric == nullptr || common.status != KLU_OK) return nullptr;
  if (max_fill > 0 && factors->fill() > max_fill) return nullptr;
  klu_l_flops(factors->symbolic, factors->numeric, &common);
  return factors;
}

void KluSolver::choose() {
  std::vector<std::string> candidates = {"COLAMD", "COLAMD btf", "AMD"};
  if (!settings_.ordering.empty()) candidates.emplace_back("given");
  if (std::ranges::find(candidates, settings_.only) != candidates.end()) candidates = {settings_.only};
  std::unique_ptr<Factors> best;
  std::ostringstream trials;
  for (const auto& name : candidates) {
    // Memory grows by a fifth at a time, so a candidate a little better than the best may ask for a little more.
    auto trial = attempt(name, best ? best->fill() * 5 / 4 : settings_.max_fill);
    trials << (best || !trials.str().empty() ? ", " : "") << name << ' ';
    if (!trial) {
      trials << "given up";
      continue;
    }
    trials << trial->fill();
    if (best && trial->common.flops >= best->common.flops) continue;
    std::swap(factors_, trial);
    const double residual = prove();
    std::swap(factors_, trial);
    if (residual < accept_below) best = std::move(trial);
    else trials << " (residual " << residual << ')';
  }
  trials_ = trials.str();
  factors_ = std::move(best);
}

void KluSolver::factor_anew() {
  if (!factors_) {
    choose();
    if (!factors_) throw SingularMatrix("KLU: no ordering gives usable factors: " + trials_, -1);
  } else {
    auto& common = factors_->common;
    klu_l_free_numeric(&factors_->numeric, &common);
    factors_->numeric =
        klu_l_factor(starts_.data(), rows_.data(), const_cast<double*>(values().data()), factors_->symbolic, &common);
    if (factors_->numeric == nullptr || common.status != KLU_OK) {
      const Index column = common.status == KLU_SINGULAR ? common.singular_col : -1;
      klu_l_free_numeric(&factors_->numeric, &common);
      if (common.status == KLU_OUT_OF_MEMORY) throw std::bad_alloc();
      throw SingularMatrix("KLU: the matrix is singular", column);
    }
    klu_l_flops(factors_->symbolic, factors_->numeric, &common);
  }
  record(factors_->fill(), factors_->common.flops);
}

bool KluSolver::refactor() {
  if (!factors_ || factors_->numeric == nullptr) return false;
  auto& common = factors_->common;
  const auto ok = klu_l_refactor(starts_.data(), rows_.data(), const_cast<double*>(values().data()), factors_->symbolic,
                                 factors_->numeric, &common);
  return ok != 0 && common.status == KLU_OK;
}

void KluSolver::substitute(std::span<double> b) {
  klu_l_solve(factors_->symbolic, factors_->numeric, pattern().n(), 1, b.data(), &factors_->common);
}

std::string KluSolver::chosen() const { return factors_ ? std::string(library) + " " + factors_->name : ""; }

std::string KluSolver::describe() const {
  std::ostringstream line;
  line << "KLU " << KLU_MAIN_VERSION << '.' << KLU_SUB_VERSION << '.' << KLU_SUBSUB_VERSION;
  if (factors_) {
    line << ", ordering " << factors_->name << ", fill " << statistics().fill << ", residual "
         << statistics().first_residual << " (tried: " << trials_ << ')';
  }
  return line.str();
}

}  // namespace talus::linear
