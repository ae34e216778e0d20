// SPDX-License-Identifier: GPL-3.0-or-later
// linear.h: the front door of linear/: sparse symmetric positive definite systems, by factorisation or by
// iteration, and the eigenvectors of small matrices.
#pragma once

#include "conjugate_gradients.h"
#include "elimination_order.h"
#include "memory.h"
#include "repeated_sum.h"
#include "sparse_cholesky.h"
#include "sparse_solver.h"
#include "stored_place.h"
#include "symmetric_eigen.h"
