// SPDX-License-Identifier: GPL-3.0-or-later
// geometry.h: the front door of geometry/: what can be measured of a shape (Sections 3.2, 3.3 and 6).
//
// A shape is a PatchAssembly with positions, 3 x places in any unit of length; angles are in radians. Angle
// defects g with their gradients, energies, curvatures, maps and roughness; distances to a surface, and
// whether triangles cut each other.
#pragma once

#include "angle_defect.h"
#include "angle_sum.h"
#include "border_way.h"
#include "boundary_crossings.h"
#include "box_tree.h"
#include "corner_geometry.h"
#include "elastic_energy.h"
#include "maps.h"
#include "patch_measures.h"
#include "principal_curvatures.h"
#include "roughness.h"
#include "second_derivatives.h"
#include "spatial_order.h"
#include "surface_distance.h"
#include "triangle_intersection.h"
#include "vertex_normals.h"
