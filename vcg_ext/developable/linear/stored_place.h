// SPDX-License-Identifier: GPL-3.0-or-later
// stored_place.h: where a sparse matrix stores an entry.
#pragma once

#include "sparse_cholesky.h"

#include <algorithm>

namespace developable {

/// The place of an entry that is stored, among all stored values of a compressed matrix.
inline int storedPlace(const SparseMatrix& matrix, int row, int column) {
	const int* const rows = matrix.innerIndexPtr();
	const int *const begin = rows + matrix.outerIndexPtr()[column], *const end =
																		rows +
																		matrix.outerIndexPtr()[column + 1];
	return static_cast<int>(std::lower_bound(begin, end, row) - rows);
}

} // namespace developable
