// SPDX-License-Identifier: GPL-3.0-or-later
// repeated_sum.cpp: the places of entries, and sums there.
#include "repeated_sum.h"

#include "stored_place.h"

#include <algorithm>

namespace developable {

const SparseMatrix& RepeatedSum::of(const Entries& entries, int size) {
	if (matrix_.rows() != size || places_.size() != entries.size() || !add(entries))
		findPlaces(entries, size);
	return matrix_;
}

/// \return false where an entry belongs to another place than before
bool RepeatedSum::add(const Entries& entries) {
	double* const values = matrix_.valuePtr();
	std::fill_n(values, matrix_.nonZeros(), 0.0);
	for (std::size_t i = 0; i < entries.size(); ++i) {
		const int place = places_[i], column = entries[i].col();
		if (matrix_.innerIndexPtr()[place] != entries[i].row() || place < matrix_.outerIndexPtr()[column] ||
			place >= matrix_.outerIndexPtr()[column + 1])
			return false;
		values[place] += entries[i].value();
	}
	return true;
}

void RepeatedSum::findPlaces(const Entries& entries, int size) {
	matrix_.resize(size, size);
	matrix_.setFromTriplets(entries.begin(), entries.end());
	places_.resize(entries.size());
	std::transform(entries.begin(), entries.end(), places_.begin(), [&](const Eigen::Triplet<double>& entry) {
		return storedPlace(matrix_, entry.row(), entry.col());
	});
}

} // namespace developable
