// SPDX-License-Identifier: GPL-3.0-or-later
// elimination_order.cpp: METIS by way of CHOLMOD, or Eigen's minimum degree.
#include "elimination_order.h"

#ifdef DEVELOPABLE_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#include <new>
#include <out_of_memory.h>
#else
#include <Eigen/OrderingMethods>
#endif

namespace developable {

#ifdef DEVELOPABLE_WITH_CHOLMOD

std::vector<int> eliminationOrder(const Eigen::SparseMatrix<double>& lower) {
	std::vector<int> order(lower.rows());
	cholmod_common common;
	cholmod_start(&common);
	common.print = 0;
	forgetOutOfMemory();
	cholmod_sparse view = Eigen::viewAsCholmod(lower.selfadjointView<Eigen::Lower>());
	constexpr int postordered = 1;
	const bool found = cholmod_metis(&view, nullptr, 0, postordered, order.data(), &common) != 0;
	cholmod_finish(&common);
	if (!found || wasOutOfMemory() != 0)
		throw std::bad_alloc();
	return order;
}

#else

std::vector<int> eliminationOrder(const Eigen::SparseMatrix<double>& lower) {
	Eigen::PermutationMatrix<Eigen::Dynamic> inverse;
	Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), inverse);
	return {inverse.indices().begin(), inverse.indices().end()};
}

#endif

std::vector<int> eliminationOrder(const std::vector<int>& ofOther, int rowsForEach) {
	std::vector<int> order;
	order.reserve(ofOther.size() * rowsForEach);
	for (const int row : ofOther)
		for (int i = 0; i < rowsForEach; ++i)
			order.push_back(row * rowsForEach + i);
	return order;
}

} // namespace developable
