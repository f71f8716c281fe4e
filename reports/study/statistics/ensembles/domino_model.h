#pragma once

namespace plumb::ensembles {

/// A row of dominoes on edge that topple about their front feet, without friction between them and with impacts of
/// restitution 0.
struct DominoRow {
  double height = 1;     // m
  double thickness = 0;  // m
  double pitch = 0;      // m, from one to the next

  /// Speed of the front, m/s, far along a row in which the last so many that were struck lean on each other and push
  /// with all their weight, and those behind them no longer. One: each is struck by one other and then falls alone (W.
  /// J. Stronge, Proc. R. Soc. A 409, 1987). Many: no loss but at impacts (J. M. J. van Leeuwen, Am. J. Phys. 78,
  /// 2010).
  double speed(int pushing) const;

  /// rad, how far one turns before it strikes the next.
  double strikes_at() const;
};

}  // namespace plumb::ensembles
