// SPDX-License-Identifier: GPL-3.0-or-later
// mirror_plane.cpp: many directions at first, the best of them refined.
#include "mirror_plane.h"

#include "candidate_axes.h"
#include "developable/geometry/geometry.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace developable::detail {

namespace {

constexpr int samples = 600;   ///< vertices that planes are fitted to
constexpr int firstRounds = 4; ///< of closest points, for every direction
constexpr int furtherRounds = 40;
constexpr std::size_t refined = 3; ///< directions

/// Vertices spread over all numbers.
Positions someOf(const Positions& points) {
	const Eigen::Index step = std::max<Eigen::Index>(1, points.cols() / samples);
	Positions some(3, (points.cols() + step - 1) / step);
	for (Eigen::Index i = 0; i < some.cols(); ++i)
		some.col(i) = points.col(i * step);
	return some;
}

Positions mirroredPoints(const MirrorPlane& plane, const Positions& points) {
	return points - 2 * plane.normal * ((plane.normal.transpose() * points).array() - plane.offset).matrix();
}

/// The plane that mirrors points to given ones best, in the mean square: with covariance M its normal has the
/// least n·M·n.
void fit(MirrorPlane& plane, const Positions& points, const Positions& images) {
	const Eigen::Vector3d centre = points.rowwise().mean(), imageCentre = images.rowwise().mean();
	const Eigen::Matrix3d product =
		(points.colwise() - centre) * (images.colwise() - imageCentre).transpose();
	const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(product + product.transpose());
	plane.normal = solver.eigenvectors().col(0);
	plane.offset = plane.normal.dot(centre + imageCentre) / 2;
}

class PlaneSearch {
public:
	explicit PlaneSearch(const TriangleMesh& mesh)
		: mesh_(mesh), points_(someOf(mesh.positions)), diagonal_(boxDiagonal(mesh.positions)) {}

	void refine(MirrorPlane& plane, int rounds) const {
		for (int round = 0; round < rounds; ++round) {
			MirrorPlane next = plane;
			fit(next, points_, nearest(mirroredPoints(plane, points_)));
			measure(next, points_);
			if (round > 0 && next.meanDistance > (1 - 1e-4) * plane.meanDistance)
				break;
			plane = next;
		}
	}

	void measureAll(MirrorPlane& plane) const { measure(plane, mesh_.positions); }

private:
	Positions nearest(const Positions& points) const {
		return nearestOnSurface(points, mesh_.positions, mesh_.triangles);
	}

	void measure(MirrorPlane& plane, const Positions& points) const {
		const Positions images = mirroredPoints(plane, points);
		const Eigen::VectorXd distances = (nearest(images) - images).colwise().norm() / diagonal_;
		plane.meanDistance = distances.mean();
		plane.greatestDistance = distances.maxCoeff();
	}

	const TriangleMesh& mesh_;
	const Positions points_;
	const double diagonal_;
};

/// The principal axes, and directions to the corners, edges and sides of a cube along them.
std::vector<Eigen::Vector3d> directionsOf(const Eigen::Matrix3d& covariance) {
	const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
	std::vector<Eigen::Vector3d> directions;
	for (int x = -1; x <= 1; ++x)
		for (int y = -1; y <= 1; ++y)
			for (int z = 0; z <= 1; ++z)
				if (z > 0 || y > 0 || (y == 0 && x > 0))
					directions.push_back((axes * Eigen::Vector3d(x, y, z)).normalized());
	return directions;
}

} // namespace

MirrorPlane mirrorPlane(const TriangleMesh& mesh) {
	const AreaMoments moments = areaMoments(mesh);
	const PlaneSearch search(mesh);
	std::vector<MirrorPlane> planes;
	for (const Eigen::Vector3d& direction : directionsOf(moments.covariance)) {
		MirrorPlane plane;
		plane.normal = direction;
		plane.offset = direction.dot(moments.centre);
		search.refine(plane, firstRounds);
		planes.push_back(plane);
	}
	const auto better = [](const MirrorPlane& a, const MirrorPlane& b) {
		return a.meanDistance < b.meanDistance;
	};
	std::stable_sort(planes.begin(), planes.end(), better);
	planes.resize(std::min(planes.size(), refined));
	for (MirrorPlane& plane : planes)
		search.refine(plane, furtherRounds);
	MirrorPlane best = *std::min_element(planes.begin(), planes.end(), better);
	search.measureAll(best);
	return best;
}

std::vector<int> mirroredTriangles(const TriangleMesh& mesh, const MirrorPlane& plane) {
	const int count = mesh.triangleCount();
	Positions middles(3, count);
	for (int t = 0; t < count; ++t)
		middles.col(t) = barycentre(mesh.positions, mesh.triangles.col(t));
	std::vector<int> order(count); // along x: what is farther away in x than the nearest so far is not nearer
	std::iota(order.begin(), order.end(), 0);
	std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return middles(0, a) < middles(0, b); });
	std::vector<int> result(count);
	for (int t = 0; t < count; ++t) {
		const Eigen::Vector3d image = plane.mirrored(middles.col(t));
		const auto start = std::lower_bound(order.begin(), order.end(), image[0],
											[&](int other, double x) { return middles(0, other) < x; });
		double least = std::numeric_limits<double>::infinity();
		const auto look = [&](int other) {
			const double distance = (middles.col(other) - image).squaredNorm();
			if (distance < least) {
				least = distance;
				result[t] = other;
			}
			return std::pow(middles(0, other) - image[0], 2) <= least;
		};
		for (auto next = start; next != order.end() && look(*next); ++next)
			continue;
		for (auto next = start; next != order.begin() && look(*std::prev(next)); --next)
			continue;
	}
	return result;
}

} // namespace developable::detail
