#pragma once

#include <sundials/sundials_nvector.h>

namespace talus::bridge {

/// Gives a serial vector, and all that SUNDIALS clones of it, own operations for what IDA does at each iteration and step: linear
/// combinations in one pass each, and weighted norms with eight sums side by side; long vectors on both threads. SUNDIALS' own go
/// through the vectors term by term, and its norms wait for each addition. The same bits on one thread and on two.
void use_own_operations(N_Vector v);

}  // namespace talus::bridge
