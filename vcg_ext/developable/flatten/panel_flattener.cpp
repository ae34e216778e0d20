// SPDX-License-Identifier: GPL-3.0-or-later
// panel_flattener.cpp: where a panel with holes is cut, and the layouts that are compared for that.
#include "panel_flattener.h"

#include "flat_start.h"
#include "panel_cuts.h"

#include <cmath>
#include <utility>

namespace developable::detail {

namespace {

class PanelFlattener {
public:
	/// A hole that stands for more curvature than this can't be that of a sheet, rad.
	static constexpr double greatestCurvatureOfHole = pi;
	/// Below this greatest edge strain a panel counts as developable.
	static constexpr double developableStrain = 1e-4;
	/// A hole is cut open when that lowers the mean edge strain by more than this factor.
	static constexpr double worthOfCut = 4;

	PanelFlattener(const PanelMesh& panel, int iterations, bool leastSquares, const Progress& progress)
		: panel_(panel), loops_(boundaryLoops(panel)), iterations_(iterations), leastSquares_(leastSquares),
		  progress_(progress) {}

	FlatPanel flatten() const {
		if (loops_.size() == 1)
			return minimized(panel_, conformalStart(panel_), 0);
		const PanelCuts cuts = chooseCuts(panel_, loops_, greatestCurvatureOfHole);
		std::vector<int> needed, all;
		for (const std::vector<int>& path : cuts.needed)
			needed.insert(needed.end(), path.begin(), path.end());
		all = needed;
		for (const std::vector<int>& path : cuts.atMost)
			all.insert(all.end(), path.begin(), path.end());

		const PanelMesh disk = cutOpen(panel_, all);
		const PlanePositions start = conformalStart(disk);
		const int neededCuts = static_cast<int>(cuts.needed.size());
		if (cuts.atMost.empty())
			return minimized(disk, start, neededCuts);
		const PanelMesh withHoles = cutOpen(panel_, needed);
		FlatPanel open = minimized(withHoles, sewn(disk, start, withHoles), neededCuts);
		const Eigen::VectorXd strains = edgeStrains(open);
		if (open.minimum.stopped || strains.maxCoeff() < developableStrain)
			return open;
		FlatPanel cut = minimized(disk, start, neededCuts + static_cast<int>(cuts.atMost.size()));
		return strains.mean() > worthOfCut * edgeStrains(cut).mean() ? cut : open;
	}

private:
	/// A layout of the panel with fewer cuts: vertices that the cuts had doubled go to their mean.
	static PlanePositions sewn(const PanelMesh& disk, const PlanePositions& positions,
							   const PanelMesh& mesh) {
		if (positions.cols() == 0)
			return {};
		PlanePositions sum = PlanePositions::Zero(2, mesh.vertexCount());
		Eigen::RowVectorXd count = Eigen::RowVectorXd::Zero(mesh.vertexCount());
		for (int corner = 0; corner < mesh.halfEdgeCount(); ++corner) {
			sum.col(mesh.start(corner)) += positions.col(disk.start(corner));
			count[mesh.start(corner)] += 1;
		}
		return sum.array().rowwise() / count.array();
	}

	FlatPanel minimized(const PanelMesh& mesh, PlanePositions start, int cuts) const {
		if (start.cols() == 0 || countFlipped(mesh.triangles, start) > 0)
			start = circleStart(mesh, boundaryLoops(mesh));
		FlatPanel flat{mesh, std::move(start), {}, cuts};
		if (flat.positions.cols() == 0)
			flat.positions = PlanePositions::Zero(2, mesh.vertexCount());
		if (countFlipped(mesh.triangles, flat.positions) > 0)
			return flat; // beyond double precision; reported as flipped faces
		PlaneSprings springs(mesh);
		FlipFreeNewton newton(springs, flat.positions);
		flat.minimum = newton.minimize(iterations_, progress_);
		if (flat.minimum.converged && !leastSquares_)
			newton.lessenMeanStrain();
		return flat;
	}

	const PanelMesh& panel_;
	std::vector<std::vector<int>> loops_;
	int iterations_;
	bool leastSquares_;
	const Progress& progress_;
};

} // namespace

Eigen::VectorXd edgeStrains(const FlatPanel& panel) {
	std::vector<double> strains;
	for (int h = 0; h < panel.mesh.halfEdgeCount(); ++h)
		if (panel.mesh.firstOfEdge(h)) {
			const double length = panel.mesh.length(h);
			const double flat =
				(panel.positions.col(panel.mesh.end(h)) - panel.positions.col(panel.mesh.start(h))).norm();
			strains.push_back(std::abs(flat - length) / length);
		}
	return Eigen::Map<Eigen::VectorXd>(strains.data(), strains.size());
}

FlatPanel flattenPanel(const PanelMesh& panel, int iterations, bool leastSquares, const Progress& progress) {
	return PanelFlattener(panel, iterations, leastSquares, progress).flatten();
}

} // namespace developable::detail
