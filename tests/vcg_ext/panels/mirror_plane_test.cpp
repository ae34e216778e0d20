// SPDX-License-Identifier: GPL-3.0-or-later
// The plane of what is symmetric, and that nothing else is.
#include "developable/panels/mirror_plane.h"

#include "developable/panels/cut_into_panels.h"
#include "support/shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace developable::test {
namespace {

using detail::MirrorPlane;
using detail::mirrorPlane;

/// A lump that is its own mirror image about the plane x = 0, though its triangles are not, or are.
TriangleMesh pear(int subdivisions = 3, bool mirroredTriangles = false) {
	TriangleMesh mesh = sphere(1, subdivisions);
	const Eigen::Matrix3d turn = Eigen::Quaterniond(0.9, 0.2, -0.3, 0.1).normalized().toRotationMatrix();
	for (auto point : mesh.positions.colwise()) {
		const Eigen::Vector3d p = mirroredTriangles ? Eigen::Vector3d(point) : turn * point;
		point = Eigen::Vector3d(1.2 * p.x(), 1.5 * p.y() + 0.4 * p.z() * p.z(), p.z() + 0.3 * p.y() * p.y());
	}
	return mesh;
}

Eigen::Matrix3d turned() {
	return Eigen::Quaterniond(0.3, -0.5, 0.7, 0.4).normalized().toRotationMatrix();
}

TEST(MirrorPlane, isFoundHoweverTheSurfaceIsTurned) {
	TriangleMesh mesh = pear();
	mesh.positions = (turned() * mesh.positions).colwise() + Eigen::Vector3d(1, 2, 3);
	const MirrorPlane plane = mirrorPlane(mesh);
	EXPECT_TRUE(plane.isSymmetric());
	EXPECT_NEAR(std::abs(plane.normal.dot(turned().col(0))), 1, 1e-4);
	EXPECT_NEAR(plane.heightOf(Eigen::Vector3d(1, 2, 3)), 0, 0.01);
	const Eigen::Vector3d point(0.3, 5, -2);
	EXPECT_NEAR((plane.mirrored(plane.mirrored(point)) - point).norm(), 0, 1e-12);
	EXPECT_NEAR(plane.heightOf(plane.mirrored(point)), -plane.heightOf(point), 1e-12);
}

TEST(MirrorPlane, isNoneOfWhatIsNotSymmetric) {
	TriangleMesh mesh = pear();
	for (auto point : mesh.positions.colwise())
		point.y() += 0.25 * point.x() * point.x() * point.x();
	EXPECT_FALSE(mirrorPlane(mesh).isSymmetric());
}

TEST(MirrorPlane, bringsMostTrianglesToTheOtherSideAndBack) {
	const TriangleMesh mesh = pear();
	const MirrorPlane plane = mirrorPlane(mesh);
	const std::vector<int> mirrored = mirroredTriangles(mesh, plane);
	const double edge = meanEdgeLength(assembled(mesh));
	for (int t = 0; t < mesh.triangleCount(); ++t) {
		const auto middle = [&](int triangle) -> Eigen::Vector3d {
			return mesh.positions(Eigen::all, mesh.triangles.col(triangle)).rowwise().mean();
		};
		EXPECT_LT((middle(mirrored[t]) - plane.mirrored(middle(t))).norm(), edge);
	}
}

/// The share of the area whose mirror image has the panel that mirrors its own.
double symmetricShare(const TriangleMesh& mesh, const CutResult& cut) {
	Positions middles(3, cut.mesh.triangles.cols());
	Eigen::VectorXd areas(middles.cols());
	for (Eigen::Index t = 0; t < middles.cols(); ++t) {
		Eigen::Matrix3d corners;
		for (int corner = 0; corner < 3; ++corner) {
			const VertexOrigin origin = cut.mesh.originOf(cut.mesh.triangles(corner, t));
			corners.col(corner) = (1 - origin.share) * mesh.positions.col(origin.first) +
								  origin.share * mesh.positions.col(origin.second);
		}
		middles.col(t) = corners.rowwise().mean();
		areas[t] = (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).norm();
	}
	std::map<std::pair<int, int>, double> shared; // area of a panel whose image lies in another
	for (Eigen::Index t = 0; t < middles.cols(); ++t) {
		const Eigen::Vector3d image = middles.col(t).cwiseProduct(Eigen::Vector3d(-1, 1, 1));
		Eigen::Index nearest = 0;
		(middles.colwise() - image).colwise().squaredNorm().minCoeff(&nearest);
		shared[{cut.mesh.panel[t], cut.mesh.panel[nearest]}] += areas[t];
	}
	std::map<int, double> most;
	for (const auto& [panels, area] : shared)
		most[panels.first] = std::max(most[panels.first], area);
	double sum = 0;
	for (const auto& [panel, area] : most)
		sum += area;
	return sum / areas.sum();
}

TEST(CutIntoPanels, mirrorsLeftAndRight) {
	CutOptions options;
	options.symmetric = true;
	for (const bool mirroredTriangles : {true, false}) {
		const TriangleMesh mesh = pear(3, mirroredTriangles);
		const CutResult cut = cutIntoPanels(mesh, {}, options);
		EXPECT_EQ(cut.report.status, Status::Converged);
		EXPECT_TRUE(cut.report.notes.empty());
		// Seams run through vertices that are near, which are not the same on both sides.
		EXPECT_GT(symmetricShare(mesh, cut), mirroredTriangles ? 0.95 : 0.8);
	}
}

TEST(CutIntoPanels, saysThatASurfaceIsNotSymmetric) {
	TriangleMesh mesh = pear(1);
	for (auto point : mesh.positions.colwise())
		point.y() += 0.25 * point.x() * point.x() * point.x();
	CutOptions options;
	options.symmetric = true;
	const CutReport report = cutIntoPanels(mesh, {}, options).report;
	ASSERT_FALSE(report.notes.empty());
	EXPECT_EQ(report.notes.back().rfind("The surface is not symmetric: its best mirror image is ", 0), 0U);
}

} // namespace
} // namespace developable::test
