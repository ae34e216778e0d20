// SPDX-License-Identifier: GPL-3.0-or-later
// strain_bounds.h: how far a material may be stretched and compressed, in which directions.
#pragma once

namespace developable {

/// By how much a strain of a pattern may be beyond its bound and still counts as within it.
constexpr double patternTolerance = 1e-4;

/// Shares of length: 0.02 is two per cent.
struct DirectionBounds {
	double stretch = 0;
	double compression = 0;
};

/// Bounds on the map from the flat pattern to the shape. Stretch means that the shape is longer than the
/// pattern. A sign whose bounds are the same for warp, weft and bias is bounded in every direction, else in
/// these alone.
struct StrainBounds {
	DirectionBounds warp; ///< along the grain; in every direction where the material is not directed
	DirectionBounds weft; ///< across the grain
	DirectionBounds bias; ///< at 45° to it, on both sides
	bool directed = false;

	/// Bounds that hold in every direction.
	static StrainBounds isotropic(double stretch, double compression) {
		StrainBounds bounds;
		bounds.warp = bounds.weft = bounds.bias = {stretch, compression};
		return bounds;
	}

	/// Whether a sign is bounded alike in every direction. \param sign  of DirectionBounds
	bool sameInEveryDirection(double DirectionBounds::*sign) const {
		return !directed || (warp.*sign == weft.*sign && warp.*sign == bias.*sign);
	}

	/// Whether any strain is allowed at all.
	bool any() const;
};

/// \throws InvalidParameter  when a bound is negative or not a number, a stretch above 10 (a thousand per
///                           cent), or a compression 1 (a hundred per cent) or above
void requireValid(const StrainBounds& bounds);

} // namespace developable
