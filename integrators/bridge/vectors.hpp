#pragma once

#include <nvector/nvector_serial.h>

#include <new>
#include <span>
#include <utility>

#include "bridge/vector_operations.hpp"

namespace talus::bridge {

inline std::span<double> view(N_Vector v) { return {NV_DATA_S(v), static_cast<std::size_t>(NV_LENGTH_S(v))}; }

/// Owns a serial N_Vector of zeros.
class Vector {
 public:
  Vector(sunindextype n, SUNContext context) : handle_(N_VNew_Serial(n, context)) {
    if (handle_ == nullptr) throw std::bad_alloc();
    use_own_operations(handle_);
    N_VConst(0.0, handle_);
  }
  Vector(const Vector&) = delete;
  Vector& operator=(const Vector&) = delete;
  ~Vector() { N_VDestroy(handle_); }

  [[nodiscard]] N_Vector handle() const { return handle_; }
  [[nodiscard]] std::span<double> span() const { return view(handle_); }

 private:
  N_Vector handle_;
};

}  // namespace talus::bridge
