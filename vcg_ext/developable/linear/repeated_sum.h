// SPDX-License-Identifier: GPL-3.0-or-later
// repeated_sum.h: a sparse matrix that is summed up anew in every step.
#pragma once

#include "sparse_cholesky.h"

#include <vector>

namespace developable {

/// Square matrices as sums of entries, of which many belong to one place. Where each entry goes is found with
/// the first of them, and again where the places of a later sum's entries are others.
class RepeatedSum {
public:
	using Entries = std::vector<Eigen::Triplet<double>>;

	/// \return size x size, until the next sum
	const SparseMatrix& of(const Entries& entries, int size);

private:
	bool add(const Entries& entries);
	void findPlaces(const Entries& entries, int size);

	SparseMatrix matrix_;
	std::vector<int> places_; // per entry, among the stored values
};

} // namespace developable
