// SPDX-License-Identifier: GPL-3.0-or-later
// multifrontal.h: the numbers of a supernodal Cholesky factor, subtrees of the elimination tree side by side.
#pragma once

#include "sparse_cholesky.h"

#include <vector>

namespace developable {

/// The columns of a factor in groups: all of a supernode's have the same rows. The arrays are as CHOLMOD
/// finds them.
struct Supernodes {
	int count;
	const int* firstColumn; ///< per supernode, and the end
	const int* rowStart;    ///< per supernode where its rows begin, and the end
	const int* numberStart; ///< per supernode where its numbers begin, rows x columns
	const int* rows;        ///< increasing: its own columns, and those below

	int columns(int node) const { return firstColumn[node + 1] - firstColumn[node]; }
	int rowCount(int node) const { return rowStart[node + 1] - rowStart[node]; }
	int below(int node) const { return rowCount(node) - columns(node); }
	const int* rowsOf(int node) const { return rows + rowStart[node]; }
};

/// The multifrontal method (Duff and Reid 1983, Liu 1992): a supernode takes what its children in the
/// elimination tree leave for it, is eliminated as one dense matrix, and leaves the rest to its parent.
/// Subtrees have nothing to do with each other, so that threads can work on them side by side. CHOLMOD's own
/// routine, which this stands for, has one thread.
class Multifrontal {
public:
	/// \param supernodes  whose arrays are kept as pointers
	explicit Multifrontal(const Supernodes& supernodes);

	/// \param lower    the matrix in the order of elimination, its lower triangle, columns in any order
	/// \param threads  at most so many at once; the factor has the same bits for any number
	/// \param numbers  become those of the factor
	/// \return         whether the matrix is positive definite
	bool factorize(const Eigen::Map<const SparseMatrix>& lower, int threads, double* numbers) const;

private:
	class Eliminator;

	void findTree();
	double work(int node) const;
	std::vector<double> subtreeWorks() const;
	void shareOut();

	const Supernodes nodes_;
	std::vector<std::vector<int>> children_; ///< per supernode
	std::vector<std::vector<int>> shares_;   ///< supernodes of subtrees, worked on side by side
	std::vector<int> top_;                   ///< those above the subtrees
	double work_ = 0;                        ///< of all, multiplications
};

} // namespace developable
