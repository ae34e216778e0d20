// SPDX-License-Identifier: GPL-3.0-or-later
// flat_patterns.cpp: maps of the patterns on the model.
#include "flat_patterns.h"

#include <algorithm>

namespace developable {

Eigen::VectorXd largestAtPlaces(const PatchAssembly& assembly, const FlatPatterns& patterns,
								const Eigen::VectorXd& vertexValues) {
	Eigen::VectorXd values = Eigen::VectorXd::Zero(assembly.placeCount());
	for (int vertex = 0; vertex < patterns.vertexCount(); ++vertex) {
		double& value = values[patterns.placeOfVertex[vertex]];
		value = std::max(value, vertexValues[vertex]);
	}
	return values;
}

} // namespace developable
