// SPDX-License-Identifier: GPL-3.0-or-later
// multifrontal.cpp: the elimination tree of supernodes, and the elimination of each.
#include "multifrontal.h"

#ifdef DEVELOPABLE_WITH_CHOLMOD

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <dense_threads.h>
#include <iterator>
#include <memory>
#include <new>
#include <out_of_memory.h>

// BLAS and LAPACK.
extern "C" {
void dsyrk_(const char* triangle, const char* trans, const int* n, const int* k, const double* alpha,
			const double* a, const int* lda, const double* beta, double* c, const int* ldc);
void dtrsm_(const char* side, const char* triangle, const char* trans, const char* diagonal, const int* m,
			const int* n, const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
void dpotrf_(const char* triangle, const int* n, double* a, const int* lda, int* info);
}

namespace developable {

namespace {

constexpr int shareCount = 8;
constexpr double subtreeShare = 1.0 / shareCount; ///< of all work, that a subtree is at most
constexpr double leastWork = 1e7; ///< multiplications: less is done before another thread wakes up

/// Square, column by column; of it only the lower triangle counts.
using Remainder = std::unique_ptr<double[]>;

} // namespace

/// Eliminates supernodes one after the other, each after its children.
class Multifrontal::Eliminator {
public:
	/// \param remainders  per supernode, what it leaves to its parent
	Eliminator(const Multifrontal& tree, const Eigen::Map<const SparseMatrix>& lower, double* numbers,
			   std::vector<Remainder>& remainders)
		: tree_(tree), nodes_(tree.nodes_), lower_(lower), numbers_(numbers), remainders_(remainders),
		  placeOfRow_(lower.rows()) {}

	/// \return whether it is positive definite
	bool eliminate(int node) {
		const int columns = nodes_.columns(node), rows = nodes_.rowCount(node);
		double* const front = numbers_ + nodes_.numberStart[node];
		gather(node, front);
		int failed = 0;
		dpotrf_("L", &columns, front, &rows, &failed);
		if (failed == 0)
			leaveRest(node, front);
		for (const int child : tree_.children_[node])
			remainders_[child].reset();
		if (wasOutOfMemory() != 0)
			throw std::bad_alloc();
		return failed == 0;
	}

private:
	/// The matrix's own numbers, and the children's that belong to the supernode's columns.
	void gather(int node, double* front) {
		const int columns = nodes_.columns(node), rows = nodes_.rowCount(node);
		for (int i = 0; i < rows; ++i)
			placeOfRow_[nodes_.rowsOf(node)[i]] = i;
		std::fill_n(front, std::ptrdiff_t(rows) * columns, 0.0);
		for (int column = 0; column < columns; ++column) {
			double* const to = front + std::ptrdiff_t(column) * rows;
			for (Eigen::Map<const SparseMatrix>::InnerIterator entry(lower_,
																	 nodes_.firstColumn[node] + column);
				 entry; ++entry)
				to[placeOfRow_[entry.row()]] += entry.value();
		}
		for (const int child : tree_.children_[node])
			addRemainder(child, 0, columns, front, rows);
	}

	/// The rows below, and what they and the children leave to the parent.
	void leaveRest(int node, double* front) {
		const int columns = nodes_.columns(node), rows = nodes_.rowCount(node), below = rows - columns;
		if (below == 0)
			return;
		constexpr double one = 1, minusOne = -1, zero = 0;
		double* const lowerRows = front + columns;
		dtrsm_("R", "L", "C", "N", &below, &columns, &one, front, &rows, lowerRows, &rows);
		Remainder& rest = remainders_[node];
		rest.reset(new double[std::size_t(below) * below]); // not cleared: a large part of the work is small
		dsyrk_("L", "N", &below, &columns, &minusOne, lowerRows, &rows, &zero, rest.get(), &below);
		for (const int child : tree_.children_[node])
			addRemainder(child, columns, rows, rest.get(), below);
	}

	/// Those columns of what a child leaves that are between two places among its parent's rows.
	/// \param to  where they begin there, columns with so many rows each, of which the first may be missing
	void addRemainder(int child, int begin, int end, double* to, int rows) {
		const int count = nodes_.below(child);
		const int* const childRows = nodes_.rowsOf(child) + nodes_.columns(child);
		places_.resize(count);
		for (int i = 0; i < count; ++i)
			places_[i] = placeOfRow_[childRows[i]];
		const int first =
			static_cast<int>(std::lower_bound(places_.begin(), places_.end(), begin) - places_.begin());
		for (int column = first; column < count && places_[column] < end; ++column) {
			const double* const from = remainders_[child].get() + std::ptrdiff_t(column) * count;
			double* const sum = to + std::ptrdiff_t(places_[column] - begin) * rows;
			for (int i = column; i < count; ++i)
				sum[places_[i] - begin] += from[i];
		}
	}

	const Multifrontal& tree_;
	const Supernodes& nodes_;
	const Eigen::Map<const SparseMatrix>& lower_;
	double* const numbers_;
	std::vector<Remainder>& remainders_;
	std::vector<int> placeOfRow_; ///< among the rows of the supernode at work
	std::vector<int> places_;     ///< the same of a child's rows
};

Multifrontal::Multifrontal(const Supernodes& supernodes) : nodes_(supernodes), children_(supernodes.count) {
	findTree();
	for (int node = 0; node < nodes_.count; ++node)
		work_ += work(node);
	shareOut();
}

void Multifrontal::findTree() {
	std::vector<int> nodeOfColumn(nodes_.firstColumn[nodes_.count]);
	for (int node = 0; node < nodes_.count; ++node)
		std::fill(nodeOfColumn.begin() + nodes_.firstColumn[node],
				  nodeOfColumn.begin() + nodes_.firstColumn[node + 1], node);
	for (int node = 0; node < nodes_.count; ++node)
		if (nodes_.below(node) > 0)
			children_[nodeOfColumn[nodes_.rowsOf(node)[nodes_.columns(node)]]].push_back(node);
}

double Multifrontal::work(int node) const {
	const double columns = nodes_.columns(node), below = nodes_.below(node);
	return columns * (columns * columns / 3 + columns * below + below * below);
}

std::vector<double> Multifrontal::subtreeWorks() const {
	std::vector<double> works(nodes_.count);
	for (int node = 0; node < nodes_.count; ++node) {
		works[node] = work(node);
		for (const int child : children_[node])
			works[node] += works[child];
	}
	return works;
}

/// Subtrees go one by one, the dearest first, to where there is least to do so far.
void Multifrontal::shareOut() {
	const std::vector<double> works = subtreeWorks();
	const auto isTop = [&](int node) { return works[node] > subtreeShare * work_; };
	std::vector<int> roots;
	for (int node = 0; node < nodes_.count; ++node) {
		if (isTop(node)) {
			top_.push_back(node);
			std::remove_copy_if(children_[node].begin(), children_[node].end(), std::back_inserter(roots),
								isTop);
		} else if (nodes_.below(node) == 0) {
			roots.push_back(node);
		}
	}
	std::stable_sort(roots.begin(), roots.end(), [&](int a, int b) { return works[a] > works[b]; });
	std::array<double, shareCount> load = {};
	std::vector<int> share(nodes_.count);
	for (const int root : roots) {
		share[root] = static_cast<int>(std::min_element(load.begin(), load.end()) - load.begin());
		load[share[root]] += works[root];
	}
	for (int node = nodes_.count - 1; node >= 0; --node)
		if (!isTop(node))
			for (const int child : children_[node])
				share[child] = share[node];
	shares_.resize(shareCount);
	for (int node = 0; node < nodes_.count; ++node)
		if (!isTop(node))
			shares_[share[node]].push_back(node);
}

bool Multifrontal::factorize(const Eigen::Map<const SparseMatrix>& lower, int threads,
							 double* numbers) const {
	std::vector<Remainder> remainders(nodes_.count);
	const auto eliminate = [&](const std::vector<int>& nodes) {
		forgetOutOfMemory();
		Eliminator eliminator(*this, lower, numbers, remainders);
		return std::all_of(nodes.begin(), nodes.end(), [&](int node) { return eliminator.eliminate(node); });
	};
	const DenseThreads all(work_ < leastWork ? 1 : threads);
	std::atomic<bool> positiveDefinite = true;
	DenseThreads::run(shareCount, [&](int piece) {
		const DenseThreads alone(1);
		if (!eliminate(shares_[piece]))
			positiveDefinite = false;
	});
	return positiveDefinite && eliminate(top_);
}

} // namespace developable

#endif
