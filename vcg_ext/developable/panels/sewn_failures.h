// SPDX-License-Identifier: GPL-3.0-or-later
// sewn_failures.h: which panels do not hold when all are sewn together, and which of these to do something
// about.
#pragma once

#include "sewn_panels.h"

namespace developable::detail {

/// How bad it is that panels are not developable, in any unit; 0 when all are.
double totalExcess(const SewnPanels& sewn);

/// The panel that holds least, of those that do not; -1: all hold.
int worstOf(const SewnPanels& sewn);

/// All panels that do not hold, worst first.
std::vector<int> worstFirst(const SewnPanels& sewn);

/// Of the panels that do not hold those to be divided. All that overlap themselves or bear too little; else
/// one, as others may hold without it: that with most curvature left or, where none has any, that moves
/// farthest.
std::vector<int> panelsToDivide(const SewnPanels& sewn);

/// Where what does not hold is worst, per panel of those.
std::vector<Eigen::Vector3d> worstPoints(const SewnPanels& sewn);

/// Whether it is developable, but overlaps itself when laid flat.
bool overlaps(const CutPanel& panel);

/// Whether some panels do not hold, and all of these overlap themselves.
bool onlyOverlap(const SewnPanels& sewn);

/// Whether a dart may help: it does not where a panel overlaps itself when laid flat.
bool wantsDart(const CutPanel& panel);

/// The same in a round of dividing, the first of which is 0: in the first rounds as above, later the worst
/// third of what does not hold; in the end, or where most do not hold and there is no time left to try, all
/// of it, for it has to end.
std::vector<int> panelsToDivideIn(int round, bool mayTry, const SewnPanels& sewn);

} // namespace developable::detail
