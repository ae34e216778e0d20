// SPDX-License-Identifier: GPL-3.0-or-later
// hostile_mesh.h: small meshes with all that makes a method stumble.
#pragma once

#include "random.h"

#include "developable/mesh/mesh.h"

namespace developable::fuzz {

/// A mesh of some tens of triangles: grids, bands with and without a twist, tubes, tori, fans, closed
/// surfaces and heaps of triangles, alone or several; then, at random, with triangles turned round, twice
/// there, thin or without area, with edges and vertices where more meet than should, coincident and unused
/// vertices, extreme scales and coordinates of few bits, selections and labels.
TriangleMesh hostileMesh(Random& random);

/// How to take it apart; now and then an option is out of its range.
PatchOptions hostilePatchOptions(Random& random, const TriangleMesh& mesh);

} // namespace developable::fuzz
