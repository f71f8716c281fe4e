#include "solver/lcp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// The variables are w (0 ... n-1), z (n ... 2n-1) and the artificial one (2n). The rows are w - M z - d z0 = q in
/// terms of the current basis, whose own columns, those of the identity, are not stored; those of w are the inverse of
/// the basis. An entering variable's column then is that of the leaving one.
class Tableau {
 public:
  Tableau(std::span<const double> m, std::span<const double> q, double noise)
      : n_(q.size()), width_(n_ + 2), noise_(std::max(noise, lcp_round_off)), cell_(n_ * width_), column_(2 * n_ + 1) {
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < n_; ++j) at(i, j) = -m[i * n_ + j];
      // Scaled like the row, so that rows of different units have the same weight.
      const double slope = std::max(largest(m.subspan(i * n_, n_)), std::numeric_limits<double>::min());
      at(i, n_) = -slope;
      steepest_ = std::max(steepest_, slope);
      at(i, right()) = q[i];
      basis_.push_back(i);
      column_[i] = in_basis;
      column_[n_ + i] = i;
    }
    column_[artificial()] = n_;
    negligible_ = noise_ * largest(q);
  }

  std::optional<std::vector<double>> solve() {
    std::optional<std::size_t> row = first_row();
    if (!row) return std::vector<double>(n_, 0);  // q >= 0
    std::size_t entering = artificial();
    // Lexicographic pivoting visits no basis twice; the bound guards against rounding.
    for (std::size_t pivots = 0; pivots < 50 * n_ + 100; ++pivots) {
      const std::size_t leaving = basis_[*row];
      pivot(*row, entering);
      // Solved as soon as the artificial variable leaves, or contributes less than rounding to every w.
      if (leaving == artificial() || steepest_ * excess() <= negligible_) return values();
      entering = leaving < n_ ? leaving + n_ : leaving - n_;
      row = blocking_row(column_[entering]);
      if (!row) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t in_basis = std::numeric_limits<std::size_t>::max();

  std::size_t artificial() const { return 2 * n_; }
  std::size_t right() const { return n_ + 1; }
  double& at(std::size_t row, std::size_t column) { return cell_[row * width_ + column]; }
  double at(std::size_t row, std::size_t column) const { return cell_[row * width_ + column]; }
  /// The entry of a variable that may be in the basis.
  double of(std::size_t row, std::size_t variable) const {
    if (column_[variable] != in_basis) return at(row, column_[variable]);
    return basis_[row] == variable ? 1 : 0;
  }

  static double largest(std::span<const double> values) {
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
  }

  /// The value of the artificial variable.
  double excess() const {
    const auto row = std::find(basis_.begin(), basis_.end(), artificial());
    return row == basis_.end() ? 0 : at(static_cast<std::size_t>(row - basis_.begin()), right());
  }

  /// Whether row r leaves before row s as the variable of `column` grows: r / |column| is lexicographically smaller.
  /// Numbers that differ by no more than rounding count as ties, which the lexicographic rule resolves.
  bool before(std::size_t r, std::size_t s, std::size_t column) const {
    const double by_r = std::abs(at(r, column));
    const double by_s = std::abs(at(s, column));
    const auto differ = [relative = noise_](double x, double y, double floor) {
      return std::abs(x - y) > relative * std::max(std::abs(x), std::abs(y)) + floor;
    };
    const double x = at(r, right()) / by_r;
    const double y = at(s, right()) / by_s;
    if (differ(x, y, negligible_)) return x < y;
    for (std::size_t k = 0; k < n_; ++k) {
      const double u = of(r, k) / by_r;
      const double v = of(s, k) / by_s;
      if (differ(u, v, noise_)) return u < v;
    }
    return false;
  }

  /// The row where the artificial variable enters, just large enough to make every w >= 0.
  std::optional<std::size_t> first_row() const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < n_; ++i) {
      if (at(i, right()) < 0 && (!best || before(i, *best, column_[artificial()]))) best = i;
    }
    return best;
  }

  /// The first basic variable that falls to 0 as that of a column grows; the artificial one if it is tied for first.
  std::optional<std::size_t> blocking_row(std::size_t column) const {
    double scale = 0;
    for (std::size_t i = 0; i < n_; ++i) scale = std::max(scale, std::abs(at(i, column)));
    const double nothing = scale * noise_;
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < n_; ++i) {
      if (at(i, column) > nothing && (!best || before(i, *best, column))) best = i;
    }
    if (!best) return best;
    const double least = at(*best, right()) / at(*best, column);
    for (std::size_t i = 0; i < n_; ++i) {
      if (basis_[i] != artificial() || at(i, column) <= nothing) continue;
      if (at(i, right()) / at(i, column) <= least + negligible_) return i;
    }
    return best;
  }

  void pivot(std::size_t row, std::size_t entering) {
    const std::size_t column = column_[entering];
    const double by = at(row, column);
    at(row, column) = 1;  // of the leaving variable from here on
    for (std::size_t k = 0; k < width_; ++k) at(row, k) /= by;
    for (std::size_t i = 0; i < n_; ++i) {
      const double factor = at(i, column);
      if (i == row || factor == 0) continue;
      at(i, column) = 0;
      for (std::size_t k = 0; k < width_; ++k) at(i, k) -= factor * at(row, k);
    }
    column_[basis_[row]] = column;
    column_[entering] = in_basis;
    basis_[row] = entering;
  }

  std::vector<double> values() const {
    std::vector<double> z(n_, 0);
    for (std::size_t i = 0; i < n_; ++i) {
      if (basis_[i] >= n_ && basis_[i] < 2 * n_) z[basis_[i] - n_] = std::max(at(i, right()), 0.0);
    }
    return z;
  }

  std::size_t n_, width_;
  double noise_;
  double negligible_ = 0;  // a w up to this counts as zero
  double steepest_ = 0;    // greatest growth of a w with the artificial variable
  std::vector<double> cell_;
  std::vector<std::size_t> column_;  // of each variable that is not in the basis
  std::vector<std::size_t> basis_;   // the variable of each row
};

}  // namespace

std::optional<std::vector<double>> solve_lcp(std::span<const double> m, std::span<const double> q, double noise) {
  if (m.size() != q.size() * q.size()) throw std::invalid_argument("solve_lcp: M must have as many rows as q, squared");
  return Tableau(m, q, noise).solve();
}

}  // namespace impulse::inline IMPULSE_PRECISION
