#pragma once

#include <algorithm>
#include <array>
#include <cfenv>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/scalar.hpp"
#include "core/sparse_pattern.hpp"
#include "fv/inputs.hpp"

namespace talus::fv {

/// One of the parts of a term's places, in their order.
struct Part {
  static constexpr int of = 4;
  int number;
  [[nodiscard]] std::size_t begin(std::size_t n) const { return n * number / of; }
  [[nodiscard]] std::size_t end(std::size_t n) const { return n * (number + 1) / of; }
};

/// A term of the semi-discrete equations: one stencil kernel applied at many places. A kernel is any class with
///
///     static constexpr int n_in, n_out;    // unknowns read, rows added to
///     static constexpr bool uses_rate;     // reads y'
///     Index n_places() const;
///     void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const;   // -1: absent, see Inputs
///     template <class S>
///     void evaluate(const Context&, Index place, const Inputs<S, n_in>&, std::array<S, n_out>& out) const;
///
/// evaluate computes a flux or source once and writes it, with its signs, to every row it belongs to. The same index may
/// stand in several slots of `in` or `out`. `Context` is what the model prepares for a state (time, geometry).
/// A kernel may also have
///
///     Index alike(Index place) const;      // how many places from this one on take the same way through the code, at least 1
///
/// and is then evaluated with core::Pack at four of them at once, for which `place` is the first.
template <class Context>
class Term {
 public:
  virtual ~Term() = default;
  /// Appends the (row, column) pairs on which the term's Jacobian can be non-zero, traced from the kernel itself.
  virtual void append_pattern(const Context& context, std::vector<std::pair<Index, Index>>& entries) const = 0;
  /// Prepares the positions of the Jacobian entries in `pattern`; called once.
  virtual void bind(const Context& context, const core::SparsePattern& pattern) = 0;
  /// Adds the places of a part to the residual.
  virtual void add_residual(const Context& context, Part part, std::span<const double> y, std::span<const double> yp,
                            std::span<double> r) const = 0;
  /// Adds dF/dy + c_j dF/dy' of a part to `values`, in the order of the bound pattern.
  virtual void add_jacobian(const Context& context, Part part, std::span<const double> y, std::span<const double> yp,
                            double c_j, std::span<double> values) const = 0;
  /// Appends the rows that a part adds to.
  virtual void append_rows(Part part, std::vector<Index>& rows) const = 0;
};

namespace detail {

/// Where a floating-point exception is to be trapped, lanes that nobody reads would trap, too.
inline bool packs_allowed() { return fegetexcept() == 0; }

template <class Kernel, class Context>
class KernelTerm final : public Term<Context> {
  static constexpr int lanes = core::Pack::lanes;
  static constexpr bool in_packs = requires(const Kernel& kernel, Index place) { kernel.alike(place); };
  static constexpr int n_in = Kernel::n_in;
  static constexpr int n_out = Kernel::n_out;
  using Dual = core::Dual<n_in>;
  using Trace = core::Trace<n_in>;

 public:
  explicit KernelTerm(Kernel kernel) : kernel_(std::move(kernel)), in_(kernel_.n_places()), out_(kernel_.n_places()) {
    std::array<Index, n_in> in;
    std::array<Index, n_out> out;
    for (Index place = 0; place < kernel_.n_places(); ++place) {
      kernel_.connect(place, in, out);
      std::ranges::transform(in, in_[place].begin(), number);
      std::ranges::transform(out, out_[place].begin(), number);
    }
    if constexpr (in_packs) group();
  }

  void append_pattern(const Context& context, std::vector<std::pair<Index, Index>>& entries) const override {
    for_each_entry(context, [&](Index row, Index column) { entries.emplace_back(row, column); });
  }

  void bind(const Context& context, const core::SparsePattern& pattern) override {
    position_.clear();
    entry_.clear();
    entry_start_.assign(1, 0);
    for (std::size_t place = 0; place < in_.size(); ++place) {
      trace(context, place, [&](int o, int i) {
        position_.push_back(static_cast<std::int32_t>(pattern.find(out_[place][o], unknown_of(in_[place][i]))));
        entry_.push_back({static_cast<std::uint8_t>(o), static_cast<std::uint8_t>(i)});
      });
      entry_start_.push_back(position_.size());
    }
  }

  void append_rows(Part part, std::vector<Index>& rows) const override {
    for (std::size_t place = part.begin(in_.size()); place < part.end(in_.size()); ++place)
      for (const Index row : out_[place])
        if (row >= 0) rows.push_back(row);
  }

  void add_residual(const Context& context, Part part, std::span<const double> y, std::span<const double> yp,
                    std::span<double> r) const override {
    if (!in_packs || !packs_allowed())
      return add_places(context, part.begin(in_.size()), part.end(in_.size()), y, yp, r);
    for (std::size_t g = group_start_[part.number]; g < group_start_[part.number + 1]; ++g) {
      const Group& group = groups_[g];
      if (!group.packed) {
        add_places(context, group.begin, group.end, y, yp, r);
      } else if constexpr (in_packs) {
        if (group.whole) add_packs<true>(context, group, y.data(), yp.data(), r.data());
        else add_packs<false>(context, group, y.data(), yp.data(), r.data());
      }
    }
  }

  void add_jacobian(const Context& context, Part part, std::span<const double> y, std::span<const double> yp,
                    double c_j, std::span<double> values) const override {
    Inputs<Dual, n_in> inputs;  // an input's slope is one number: the others stay zero from place to place
    std::array<Dual, n_out> out;
    for (std::size_t place = part.begin(in_.size()); place < part.end(in_.size()); ++place) {
      for (int i = 0; i < n_in; ++i) {
        const Index index = in_[place][i];
        const double sign = index >= 0 ? 1.0 : (index < -1 ? -1.0 : 0.0);
        inputs.y[i].value = read(y, index);
        inputs.y[i].slope[i] = sign;
        if constexpr (Kernel::uses_rate) {
          inputs.rate[i].value = read(yp, index);
          inputs.rate[i].slope[i] = sign * c_j;
        }
      }
      out.fill(Dual(0.0));
      kernel_.evaluate(context, static_cast<Index>(place), inputs, out);
      for (std::size_t e = entry_start_[place]; e < entry_start_[place + 1]; ++e)
        values[position_[e]] += out[entry_[e].out].slope[entry_[e].in];
    }
  }

 private:
  void add_places(const Context& context, std::size_t begin, std::size_t end, std::span<const double> y,
                  std::span<const double> yp, std::span<double> r) const {
    Inputs<double, n_in> inputs{};
    std::array<double, n_out> out{};
    for (std::size_t place = begin; place < end; ++place) {
      for (int i = 0; i < n_in; ++i) {
        const Index index = in_[place][i];
        inputs.y[i] = read(y, index);
        if constexpr (Kernel::uses_rate) inputs.rate[i] = read(yp, index);
      }
      out.fill(0.0);
      kernel_.evaluate(context, static_cast<Index>(place), inputs, out);
      for (int o = 0; o < n_out; ++o)
        if (out_[place][o] >= 0) r[out_[place][o]] += out[o];
    }
  }

  struct Entry {
    std::uint8_t out, in;
  };
  /// Unknowns as they are kept here: half as wide, as there are many more of them than anything else.
  using Number = std::int32_t;
  static Number number(Index index) {
    if (index > std::numeric_limits<Number>::max()) throw std::length_error("make_term: too many unknowns");
    return static_cast<Number>(index);
  }

  /// Places that follow each other; if packed, they are alike, have the same inputs, and fill a pack.
  struct Group {
    Number begin, end;
    bool packed;
    bool whole;  ///< no input is absent
  };

  void group() requires in_packs {
    for (int nth = 0; nth < Part::of; ++nth) {
      const Part part{nth};
      group_start_.push_back(groups_.size());
      const auto end = static_cast<Index>(part.end(in_.size()));
      for (Index place = static_cast<Index>(part.begin(in_.size())), next; place < end; place = next) {
        const Index end_of_alike = std::min(place + kernel_.alike(place), end);
        next = place;
        while (next < end_of_alike && same_inputs(place, next)) ++next;
        const bool packed = next - place >= lanes;
        next = std::max(next, place + 1);
        const bool goes_on = !packed && groups_.size() > group_start_.back() && !groups_.back().packed;
        if (goes_on) groups_.back().end = number(next);
        else groups_.push_back({number(place), number(next), packed, packed && all_there(place)});
      }
    }
    group_start_.push_back(groups_.size());
  }

  [[nodiscard]] bool all_there(Index place) const {
    return std::ranges::all_of(in_[place], [](Number index) { return index >= 0; });
  }

  /// Whether two places read the same of their inputs, and none with the opposite sign.
  [[nodiscard]] bool same_inputs(Index a, Index b) const {
    return std::ranges::equal(in_[a], in_[b], [](Number at_a, Number at_b) {
      return (at_a < 0) == (at_b < 0) && std::min(at_a, at_b) >= -1;
    });
  }

  template <bool whole>
  void add_packs(const Context& context, const Group& group, const double* y, const double* yp, double* r) const {
    Inputs<core::Pack, n_in> inputs{};
    std::array<core::Pack, n_out> out;
    for (Number at = group.begin; at < group.end; at += lanes) {
      const Number first = std::min(at, group.end - lanes);  // the last pack may take places a second time
      for (int i = 0; i < n_in; ++i) {
        const auto gathered = [&](const double* from) {
          if (!whole && in_[first][i] < 0) return core::Pack(0.0);
          return core::Pack(from[in_[first][i]], from[in_[first + 1][i]], from[in_[first + 2][i]],
                            from[in_[first + 3][i]]);
        };
        inputs.y[i] = gathered(y);
        if constexpr (Kernel::uses_rate) inputs.rate[i] = gathered(yp);
      }
      out.fill(core::Pack(0.0));
      kernel_.evaluate(context, first, inputs, out);
      for (int lane = at - first; lane < lanes; ++lane)
        for (int o = 0; o < n_out; ++o)
          if (const Number row = out_[first + lane][o]; row >= 0) r[row] += out[o].lane[lane];
    }
  }

  /// Calls visit(o, i) for each output slot o that depends on input slot i at this place.
  template <class Visit>
  void trace(const Context& context, std::size_t place, Visit&& visit) const {
    Inputs<Trace, n_in> inputs;
    std::array<Trace, n_out> out;
    for (int i = 0; i < n_in; ++i) {
      inputs.y[i] = in_[place][i] == -1 ? Trace(0.0) : Trace::input(i);
      inputs.rate[i] = inputs.y[i];
    }
    out.fill(Trace(0.0));
    kernel_.evaluate(context, static_cast<Index>(place), inputs, out);
    for (int o = 0; o < n_out; ++o)
      for (int i = 0; i < n_in; ++i)
        if (out_[place][o] >= 0 && out[o].inputs.test(i)) visit(o, i);
  }

  template <class Visit>
  void for_each_entry(const Context& context, Visit&& visit) const {
    for (std::size_t place = 0; place < in_.size(); ++place)
      trace(context, place, [&](int o, int i) { visit(out_[place][o], unknown_of(in_[place][i])); });
  }

  Kernel kernel_;
  std::vector<std::array<Number, n_in>> in_;
  std::vector<std::array<Number, n_out>> out_;
  std::vector<std::size_t> entry_start_;
  std::vector<std::int32_t> position_;
  std::vector<Entry> entry_;
  std::vector<Group> groups_;
  std::vector<std::size_t> group_start_;  // of each part
};

}  // namespace detail

template <class Context, class Kernel>
std::unique_ptr<Term<Context>> make_term(Kernel kernel) {
  return std::make_unique<detail::KernelTerm<Kernel, Context>>(std::move(kernel));
}

}  // namespace talus::fv
