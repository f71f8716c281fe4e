#pragma once

#include <array>
#include <cstddef>

namespace plumb {

/// One step of y' = f(y) by the classical fourth-order Runge-Kutta method: what truths without a closed form are
/// integrated by, and an independent check of closed forms.
template <std::size_t N, class Derivative>
std::array<double, N> runge_kutta(const std::array<double, N>& y, double h, const Derivative& f) {
  const auto plus = [&y](const std::array<double, N>& k, double s) {
    std::array<double, N> sum = y;
    for (std::size_t i = 0; i < N; ++i) sum[i] += s * k[i];
    return sum;
  };
  const std::array<double, N> k1 = f(y);
  const std::array<double, N> k2 = f(plus(k1, h / 2));
  const std::array<double, N> k3 = f(plus(k2, h / 2));
  const std::array<double, N> k4 = f(plus(k3, h));
  std::array<double, N> next = y;
  for (std::size_t i = 0; i < N; ++i) next[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  return next;
}

/// y after that time, in as many steps.
template <std::size_t N, class Derivative>
std::array<double, N> integrated(std::array<double, N> y, double time, int steps, const Derivative& f) {
  for (int i = 0; i < steps; ++i) y = runge_kutta(y, time / steps, f);
  return y;
}

}  // namespace plumb
