// SPDX-License-Identifier: GPL-3.0-or-later
// local_state.h: the shape during the local method: every place at a height δ along its original normal.
#pragma once

#include "developable/geometry/geometry.h"
#include "local_mesh.h"

#include <algorithm>

namespace developable::detail {

/// Positions q + δn with the angle defects that belong to them, kept up to date move by move: a move costs
/// the corners of the triangles round the place and the sums at its copies and their neighbours.
class LocalState {
public:
	LocalState(const PatchAssembly& assembly, const Positions& positions,
			   AssemblingVertices assemblingVertices);

	const LocalMesh& mesh() const { return mesh_; }
	double detectFunction() const { return detectFunction_; }
	double height(int place) const { return mesh_.places[place].height; }
	double squaredDefect(int copy) const { return mesh_.copies[copy].defect * mesh_.copies[copy].defect; }

	/// Per copy of the assembly, rad.
	Eigen::VectorXd defects() const;

	/// 3 x places of the assembly.
	Positions positions() const;

	/// T = Σ g² over the copies at the place and their neighbours (Eq. 15).
	double localDetectFunction(int place) const {
		double sum = 0;
		mesh_.forEachAffected(place, [&](int copy) { sum += squaredDefect(copy); });
		return sum;
	}

	double largestSquaredDefect(int place) const {
		double largest = 0;
		mesh_.forEachAffected(place, [&](int copy) { largest = std::max(largest, squaredDefect(copy)); });
		return largest;
	}

	/// T', the derivative of T when the place moves along its normal, in closed form.
	double localDerivative(int place) const {
		double derivative = 0;
		forEachTriangle(place, [&](const Triangle& triangle) {
			Eigen::Vector3d weights;
			for (int i = 0; i < 3; ++i)
				weights[i] = mesh_.copies[triangle.copy[i]].defect;
			const AngleGradients gradients(triangle.frame(mesh_));
			derivative -= 2 * gradients.weighted(weights, triangle.own).dot(mesh_.places[place].normal);
		});
		return derivative;
	}

	/// The mean square difference in height to the neighbours, measured along the place's normal, length².
	double unevenness(int place) const {
		return meanOverNeighbours(place, [&](double difference) { return difference * difference; });
	}

	/// Its derivative when the place moves along its normal, length.
	double unevennessDerivative(int place) const {
		return meanOverNeighbours(place, [&](double difference) { return 2 * difference; });
	}

	/// Moves a place to a height along its normal.
	void moveTo(int place, double height) {
		LocalMesh::Place& moved = mesh_.places[place];
		moved.height = height;
		mesh_.forEachOwn(
			place, [&](int copy) { mesh_.copies[copy].position = moved.start + height * moved.normal; });
		forEachTriangle(place, [&](const Triangle& triangle) {
			const Eigen::Vector3d values = cotangents(triangle.frame(mesh_));
			for (int i = 0; i < 3; ++i)
				mesh_.cotangents[triangle.corner[i]] = values[i];
		});
		mesh_.forEachAffected(place, [&](int copy) {
			const double before = squaredDefect(copy);
			mesh_.copies[copy].defect = newDefect(copy);
			detectFunction_ += squaredDefect(copy) - before;
		});
	}

private:
	/// A triangle, corner by corner in the assembly's order.
	struct Triangle {
		int own; ///< from which corner it is seen
		int copy[3], corner[3];

		Triangle(const LocalMesh& mesh, int ownCopy, int ownCorner) : own(mesh.corners[ownCorner].number) {
			copy[own] = ownCopy;
			corner[own] = ownCorner;
			const int others[] = {nextCorner(own), previousCorner(own)};
			for (int other = 0; other < 2; ++other) {
				copy[others[other]] = mesh.corners[ownCorner].copy[other];
				corner[others[other]] = mesh.corners[ownCorner].corner[other];
			}
		}

		TriangleFrame frame(const LocalMesh& mesh) const {
			return {mesh.copies[copy[0]].position, mesh.copies[copy[1]].position,
					mesh.copies[copy[2]].position};
		}
	};

	/// Calls a function with each triangle round a place.
	template <class Function>
	void forEachTriangle(int place, const Function& function) const {
		mesh_.forEachOwn(place, [&](int copy) {
			const int end = mesh_.copies[copy + 1].firstCorner;
			for (int corner = mesh_.copies[copy].firstCorner; corner < end; ++corner)
				function(Triangle(mesh_, copy, corner));
		});
	}

	/// The mean of a function of the differences in height to the neighbours, measured along the place's
	/// normal.
	template <class Function>
	double meanOverNeighbours(int place, const Function& function) const {
		double sum = 0;
		int count = 0;
		mesh_.forEachNeighbour(place, [&](int copy) {
			const LocalMesh::Place& neighbour = mesh_.places[mesh_.copies[copy].place];
			const double along = neighbour.height * neighbour.normal.dot(mesh_.places[place].normal);
			sum += function(height(place) - along);
			++count;
		});
		return sum / count;
	}

	/// The angle defect that follows from the cotangents.
	double newDefect(int copy) const {
		if (!mesh_.copies[copy].interior)
			return 0;
		AngleSum sum;
		for (int corner = mesh_.copies[copy].firstCorner; corner < mesh_.copies[copy + 1].firstCorner;
			 ++corner)
			sum.add(mesh_.cotangents[corner]);
		return sum.defect();
	}

	LocalMesh mesh_;
	double detectFunction_;
};

} // namespace developable::detail
