#pragma once

namespace talus::linear {

/// Keeps a threaded OpenBLAS to one thread of its own: more were ten times slower inside UMFPACK on busy cores.
void limit_blas_to_one_thread();

/// Makes BLAS take the work space of its calls from one thread. Throws std::bad_alloc where it is not to be had: OpenBLAS
/// would ask for it again and again, without end, in its first call.
void reserve_blas_work_space();

}  // namespace talus::linear
