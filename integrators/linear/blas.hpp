#pragma once

namespace talus::linear {

/// Whether two threads may call BLAS at once. Not with OpenBLAS built without threads, as Debian's serial variant: it
/// shares its work space without locks, and one factorisation in a hundred came out wrong (relative residual 1e-2) on
/// two busy cores.
[[nodiscard]] bool blas_allows_threads();

/// Keeps a threaded OpenBLAS to one thread of its own: more were ten times slower inside UMFPACK on busy cores.
void limit_blas_to_one_thread();

/// Makes BLAS take the work space of its calls from one thread. Throws std::bad_alloc where it is not to be had: OpenBLAS
/// would ask for it again and again, without end, in its first call.
void reserve_blas_work_space();

}  // namespace talus::linear
