// SPDX-License-Identifier: GPL-3.0-or-later
// material.h: the front door of material/: what a material bears between its flat pattern and the shape.
//
// Strain bounds and the grain that they go by, the strains of every triangle, the cost of leaving the bounds,
// and bending radii.
#pragma once

#include "bending_radius.h"
#include "border_fans.h"
#include "grain.h"
#include "hardening.h"
#include "rounded_penalty.h"
#include "strain_bounds.h"
#include "strain_penalty.h"
#include "triangle_strain.h"
