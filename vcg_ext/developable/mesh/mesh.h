// SPDX-License-Identifier: GPL-3.0-or-later
// mesh.h: the front door of mesh/: an object made of patches that are sewn together (Sections 3.1 and 4.2),
// as flat arrays.
//
// A TriangleMesh becomes a PatchAssembly (assemblePatches): patches, vertex copies, and places, which are
// linked vertex sets. Every method works on an assembly and on positions, 3 x places in the assembly's unit
// of length, which is the mesh's unless that is far too large or small (length_unit.h), and says in a report
// how it ended. Invalid input throws one of the exceptions derived from Error, with the mesh untouched.
#pragma once

#include "assemble_patches.h"
#include "assembly_parts.h"
#include "constants.h"
#include "disjoint_sets.h"
#include "exceptions.h"
#include "grouping.h"
#include "indices.h"
#include "joined_faces.h"
#include "length_unit.h"
#include "options.h"
#include "pace_of_looks.h"
#include "parallel_tasks.h"
#include "partial_assembly.h"
#include "patch_assembly.h"
#include "progress.h"
#include "report.h"
#include "task_ahead.h"
#include "triangle_mesh.h"
#include "where.h"
