#pragma once

#include <optional>
#include <string>
#include <utility>

namespace talus::steady {

/// A value, or the reason in words why there is none: "no steady state" is an answer, not an error.
template <class T>
class Answer {
 public:
  Answer(T value) : value_(std::move(value)) {}  // NOLINT(google-explicit-constructor)
  static Answer none(std::string reason) { return Answer(std::nullopt, std::move(reason)); }

  explicit operator bool() const { return value_.has_value(); }
  /// Throws std::bad_optional_access where there is none.
  [[nodiscard]] const T& value() const { return value_.value(); }
  const T& operator*() const { return value_.value(); }
  const T* operator->() const { return &value_.value(); }
  /// Empty where there is a value.
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  Answer(std::nullopt_t, std::string reason) : reason_(std::move(reason)) {}
  std::optional<T> value_;
  std::string reason_;
};

}  // namespace talus::steady
